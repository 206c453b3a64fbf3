#include "segmentation/derivatives.h"

#include <cmath>

namespace isostack {

template <int D>
double Derivatives<D>::mean_curvature() const {
  const Vector g = gradient();
  const double norm2 = g.squaredNorm();
  if (norm2 < 1e-12) return 0;
  return (norm2 * hessian.trace() - g.dot(hessian * g)) / (norm2 * std::sqrt(norm2));
}

template <int D>
double Derivatives<D>::upwind_gradient_norm(bool expands) const {
  const Vector& rising = expands ? forward : backward;
  const Vector& falling = expands ? backward : forward;
  return rising.cwiseMax(0).cwiseMax((-falling).cwiseMax(0)).norm();
}

template <int D>
Derivatives<D> derivatives_at(const Field<D>& field, std::size_t node) {
  const auto position = field.position_of(node);
  bool is_interior = true;
  for (int axis = 0; axis < D; ++axis)
    is_interior = is_interior && position[axis] > 0 && position[axis] + 1 < field.size[axis];

  const auto value = [&](int axis_a, int step_a, int axis_b, int step_b) {
    if (is_interior) {
      const auto offset = step_a * static_cast<std::ptrdiff_t>(field.stride(axis_a)) +
                          step_b * static_cast<std::ptrdiff_t>(field.stride(axis_b));
      return field.values[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + offset)];
    }
    auto at = position;
    at[axis_a] += step_a;
    at[axis_b] += step_b;
    return field.extrapolated(at);
  };

  Derivatives<D> result;
  const double centre = field.values[node];
  for (int a = 0; a < D; ++a) {
    const double h_a = field.spacing_mm[a];
    result.backward[a] = (centre - value(a, -1, a, 0)) / h_a;
    result.forward[a] = (value(a, 1, a, 0) - centre) / h_a;
    result.hessian(a, a) = (result.forward[a] - result.backward[a]) / h_a;
    for (int b = 0; b < a; ++b) {
      const double mixed = (value(a, 1, b, 1) - value(a, 1, b, -1) - value(a, -1, b, 1) + value(a, -1, b, -1)) /
                           (4 * h_a * field.spacing_mm[b]);
      result.hessian(a, b) = result.hessian(b, a) = mixed;
    }
  }
  return result;
}

template struct Derivatives<2>;
template struct Derivatives<3>;
template Derivatives<2> derivatives_at(const Field<2>&, std::size_t);
template Derivatives<3> derivatives_at(const Field<3>&, std::size_t);

}  // namespace isostack
