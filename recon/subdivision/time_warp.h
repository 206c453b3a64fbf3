#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace isostack {

/// A blend that goes on at different times at different places (Ohbuchi, Kokojima & Takahashi 2001, eq. 9): what is at
/// t in the interpolator is shown at P(x, y, t) = Σ Bᵢ(x) Bⱼ(y) Pᵢⱼ(t), in bodies with B(z), too, Bernstein polynomials
/// of degree 3 over the box of the shapes. Times run from 0 to 1.
struct TimeWarp {
  /// Pᵢⱼ at 1/3 and at 2/3, one column per control point (x fastest: 16 or 64 columns). At 0 and 1 it is 0 and 1, and a
  /// cardinal spline leads through the four.
  Eigen::Matrix2Xd controls;

  bool is_set() const { return controls.cols() > 0; }
  /// `place` in the box of the shapes.
  double shown_at(const Eigen::VectorXd& place, const Eigen::AlignedBox3d& box, double t) const;
};

/// What lies first along the direction changes first. The lag, below 1, is how much of the time the last is behind it.
TimeWarp sweep(const Eigen::VectorXd& direction, double lag);

/// Throws InputError naming what is wrong: 16 columns for figures, 64 for bodies; times that ascend within 0 and 1.
void require_warp(const TimeWarp& warp, int dimension);

}  // namespace isostack
