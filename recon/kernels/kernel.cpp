#include "recon/kernels/kernel.h"

#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// distance^power without std::pow: these run once per pair of constraints.
double integer_power(double distance, int power) {
  double result = power % 2 == 0 ? 1.0 : distance;
  const double square = distance * distance;
  for (int p = power % 2 == 0 ? 0 : 1; p < power; p += 2) result *= square;
  for (int p = power % 2 == 0 ? 0 : 1; p > power; p -= 2) result /= square;
  return result;
}

}  // namespace

int Kernel::sign() const {
  // r^p: (-1)^ceil(p/2) for odd p; r^2k log r: (-1)^(k+1).
  const int order = logarithmic ? power / 2 + 1 : (power + 1) / 2;
  return order % 2 == 0 ? 1 : -1;
}

double Kernel::value(double squared_distance) const {
  if (squared_distance <= 0) return 0;
  const double distance = std::sqrt(squared_distance);
  const double monomial = integer_power(distance, power);
  return logarithmic ? monomial * std::log(distance) : monomial;
}

double Kernel::slope_over_distance(double squared_distance) const {
  if (squared_distance <= 0) return 0;
  const double distance = std::sqrt(squared_distance);
  const double monomial = integer_power(distance, power - 2);
  return logarithmic ? monomial * (power * std::log(distance) + 1) : power * monomial;
}

double Kernel::curvature_factor(double squared_distance) const {
  if (squared_distance <= 0) return 0;
  const double distance = std::sqrt(squared_distance);
  const double monomial = integer_power(distance, power - 4);
  if (!logarithmic) return power * (power - 2) * monomial;
  return monomial * ((power - 2) * (power * std::log(distance) + 1) + power);
}

std::string Kernel::name() const {
  if (!logarithmic && power == 1) return "biharmonic";
  if (logarithmic && power == 2) return "thin_plate";
  if (!logarithmic && power == 3) return "triharmonic";
  return "r^" + std::to_string(power) + (logarithmic ? " log r" : "");
}

Kernel biharmonic() { return {.power = 1, .logarithmic = false, .tail_degree = 1}; }
Kernel thin_plate() { return {.power = 2, .logarithmic = true, .tail_degree = 1}; }
Kernel triharmonic() { return {.power = 3, .logarithmic = false, .tail_degree = 1}; }

Kernel duchon(int dimension, int order) {
  const int power = 2 * order - dimension;
  if (power <= 0)
    throw InputError("kernel",
                     "Duchon's spline of order " + std::to_string(order) + " does not exist in " +
                         std::to_string(dimension) + " dimensions",
                     "choose an order above half the dimension");
  return {.power = power, .logarithmic = power % 2 == 0, .tail_degree = order - 1};
}

Kernel kernel_named(std::string_view name) {
  for (const Kernel& kernel : {biharmonic(), thin_plate(), triharmonic()})
    if (kernel.name() == name) return kernel;
  throw InputError("kernel", "there is no kernel called '" + std::string(name) + "'",
                   "use biharmonic, thin_plate or triharmonic");
}

}  // namespace isostack
