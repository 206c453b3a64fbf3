#pragma once

#include <Eigen/Core>

#include "segmentation/field.h"

namespace isostack {

/// Finite differences of a field at one node, per mm; linear continuation beyond the border.
template <int D>
struct Derivatives {
  using Vector = Eigen::Matrix<double, D, 1>;
  using Matrix = Eigen::Matrix<double, D, D>;

  Vector backward = Vector::Zero();  ///< (φ_i − φ_{i−1}) / h along each axis
  Vector forward = Vector::Zero();   ///< (φ_{i+1} − φ_i) / h
  Matrix hessian = Matrix::Zero();   ///< central second differences, second order

  Vector gradient() const { return (backward + forward) / 2; }  ///< central, second order

  /// Divergence of ∇φ/|∇φ| in 1/mm, the sum of the principal curvatures: −1/r on a disc of radius r where
  /// φ > 0 inside. 0 where the gradient vanishes.
  double mean_curvature() const;

  /// |∇φ| for φ_t = F |∇φ| by Godunov's scheme: differences are taken from the side information comes from,
  /// which is the inside when the surface expands (F > 0).
  double upwind_gradient_norm(bool expands) const;
};

template <int D>
Derivatives<D> derivatives_at(const Field<D>& field, std::size_t node);

extern template struct Derivatives<2>;
extern template struct Derivatives<3>;
extern template Derivatives<2> derivatives_at(const Field<2>&, std::size_t);
extern template Derivatives<3> derivatives_at(const Field<3>&, std::size_t);

}  // namespace isostack
