#include "segmentation/derivatives.h"

#include <array>
#include <cmath>

namespace isostack {

template <int D>
double Derivatives<D>::mean_curvature() const {
  const double norm = gradient().norm();
  return norm > 0 ? curvature_motion() / norm : 0;
}

template <int D>
double Derivatives<D>::upwind_gradient_norm(bool expands) const {
  const Vector& rising = expands ? forward : backward;
  const Vector& falling = expands ? backward : forward;
  return rising.cwiseMax(0).cwiseMax((-falling).cwiseMax(0)).norm();
}

namespace {

/// Differences from value(axis_a, step_a, axis_b, step_b), the value that many nodes away along both axes.
template <int D, class Value>
Derivatives<D> differences(const std::array<double, D>& spacing_mm, double centre, Value value) {
  Derivatives<D> result;
  for (int a = 0; a < D; ++a) {
    const double inverse_h = 1 / spacing_mm[a];
    result.backward[a] = (centre - value(a, -1, a, 0)) * inverse_h;
    result.forward[a] = (value(a, 1, a, 0) - centre) * inverse_h;
    result.hessian(a, a) = (result.forward[a] - result.backward[a]) * inverse_h;
    for (int b = 0; b < a; ++b) {
      const double mixed = (value(a, 1, b, 1) - value(a, 1, b, -1) - value(a, -1, b, 1) + value(a, -1, b, -1)) *
                           inverse_h / (4 * spacing_mm[b]);
      result.hessian(a, b) = result.hessian(b, a) = mixed;
    }
  }
  return result;
}

}  // namespace

template <int D>
Derivatives<D> derivatives_at(const Field<D>& field, const Lattice<D>& lattice, std::size_t node,
                              typename Lattice<D>::Sides sides) {
  const float* at = field.values.data() + node;
  const double centre = *at;
  if (sides == Lattice<D>::all_sides)
    return differences<D>(lattice.spacing_mm, centre, [&](int a, int step_a, int b, int step_b) {
      return static_cast<double>(at[step_a * lattice.stride[a] + step_b * lattice.stride[b]]);
    });
  const auto position = field.position_of(node);
  return differences<D>(lattice.spacing_mm, centre, [&](int a, int step_a, int b, int step_b) {
    auto there = position;
    there[a] += step_a;
    there[b] += step_b;
    return field.extrapolated(there);
  });
}

template <int D>
Derivatives<D> derivatives_at(const Field<D>& field, std::size_t node) {
  const Lattice<D> lattice(field);
  return derivatives_at(field, lattice, node, lattice.sides_of(node));
}

template <int D>
Eigen::Matrix<double, D, 1> gradient_at(const Field<D>& field, std::size_t node) {
  const Lattice<D> lattice(field);
  const auto sides = lattice.sides_of(node);
  Eigen::Matrix<double, D, 1> gradient = Eigen::Matrix<double, D, 1>::Zero();
  for (int axis = 0; axis < D; ++axis) {
    const int reach = ((sides & lattice.before(axis)) != 0) + ((sides & lattice.after(axis)) != 0);
    if (reach == 0) continue;
    const float* at = field.values.data() + node;
    const double before = sides & lattice.before(axis) ? at[-lattice.stride[axis]] : *at;
    const double after = sides & lattice.after(axis) ? at[lattice.stride[axis]] : *at;
    gradient[axis] = (after - before) / (reach * lattice.spacing_mm[axis]);
  }
  return gradient;
}

template struct Derivatives<2>;
template struct Derivatives<3>;
template Derivatives<2> derivatives_at(const Field<2>&, std::size_t);
template Derivatives<3> derivatives_at(const Field<3>&, std::size_t);
template Derivatives<2> derivatives_at(const Field<2>&, const Lattice<2>&, std::size_t, std::uint8_t);
template Derivatives<3> derivatives_at(const Field<3>&, const Lattice<3>&, std::size_t, std::uint8_t);
template Eigen::Vector2d gradient_at(const Field<2>&, std::size_t);
template Eigen::Vector3d gradient_at(const Field<3>&, std::size_t);

}  // namespace isostack
