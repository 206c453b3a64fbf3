#pragma once

#include <Eigen/Core>

#include "segmentation/field.h"
#include "segmentation/lattice.h"

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

  /// The same times |∇φ|: φ_t under curvature motion, 1/mm.
  double curvature_motion() const {
    const Vector g = gradient();
    const double norm2 = g.squaredNorm();
    return norm2 < 1e-12 ? 0 : hessian.trace() - g.dot(hessian * g) / norm2;
  }

  /// |∇φ| for φ_t = F |∇φ| by Godunov's scheme: differences are taken from the side information comes from,
  /// which is the inside when the surface expands (F > 0).
  double upwind_gradient_norm(bool expands) const;
};

template <int D>
Derivatives<D> derivatives_at(const Field<D>& field, std::size_t node);

/// The same where the lattice and the node's sides are at hand.
template <int D>
Derivatives<D> derivatives_at(const Field<D>& field, const Lattice<D>& lattice, std::size_t node,
                              typename Lattice<D>::Sides sides);

/// Derivatives::curvature_motion of a node with all sides, and quicker.
template <int D>
inline double curvature_motion_inside(const float* at, const Lattice<D>& lattice) {
  double slope[D], norm2 = 0, along = 0, trace = 0;
  for (int a = 0; a < D; ++a) {
    const double before = at[-lattice.stride[a]], after = at[lattice.stride[a]];
    const double inverse_h = lattice.inverse_spacing[a];
    slope[a] = (after - before) * (0.5 * inverse_h);
    const double second = (after - 2 * static_cast<double>(*at) + before) * (inverse_h * inverse_h);
    norm2 += slope[a] * slope[a];
    trace += second;
    along += slope[a] * slope[a] * second;
  }
  for (int a = 1; a < D; ++a)
    for (int b = 0; b < a; ++b) {
      const std::ptrdiff_t up = lattice.stride[a] + lattice.stride[b], down = lattice.stride[a] - lattice.stride[b];
      const double mixed = (static_cast<double>(at[up]) - at[down] - at[-down] + at[-up]) *
                           (0.25 * lattice.inverse_spacing[a] * lattice.inverse_spacing[b]);
      along += 2 * slope[a] * slope[b] * mixed;
    }
  return norm2 < 1e-12 ? 0 : trace - along / norm2;
}

/// Central differences only; one-sided at the border.
template <int D>
Eigen::Matrix<double, D, 1> gradient_at(const Field<D>& field, std::size_t node);

extern template struct Derivatives<2>;
extern template struct Derivatives<3>;
extern template Derivatives<2> derivatives_at(const Field<2>&, std::size_t);
extern template Derivatives<3> derivatives_at(const Field<3>&, std::size_t);
extern template Derivatives<2> derivatives_at(const Field<2>&, const Lattice<2>&, std::size_t, std::uint8_t);
extern template Derivatives<3> derivatives_at(const Field<3>&, const Lattice<3>&, std::size_t, std::uint8_t);
extern template Eigen::Vector2d gradient_at(const Field<2>&, std::size_t);
extern template Eigen::Vector3d gradient_at(const Field<3>&, std::size_t);

}  // namespace isostack
