#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "recon/morphing/morph.h"
#include "recon/morphing/shape.h"
#include "recon/surface/implicit_function.h"

namespace isostack {

/// Points of the first and the last shape that belong together; world mm, of figures in their plane.
struct LandmarkPair {
  Eigen::Vector3d from_mm, to_mm;
};

/// A displacement w of n-dimensional space (2 or 3) that takes given values at some points: every coordinate is
/// interpolated by itself, with r² log r in 2D and r³ in 3D (Turk & O'Brien 1999, appendix). Up to n + 1 points in
/// general position displace linearly. Points are n × M.
class Warp {
 public:
  /// n × k each, k ≥ 1, the points distinct.
  Warp(const Eigen::MatrixXd& points, const Eigen::MatrixXd& displacements);

  /// x + amount · w(x).
  Eigen::MatrixXd displaced(const Eigen::MatrixXd& points, double amount) const;
  /// The x with x + amount · w(x) = y, to 1e-10 of the points' extent, by Newton's method. Throws GeometryError where
  /// it finds none, or one where the displacement folds space over.
  Eigen::MatrixXd undisplaced(const Eigen::MatrixXd& points, double amount) const;
  /// Derivatives of `displaced` at each point.
  std::vector<Eigen::MatrixXd> jacobians(const Eigen::MatrixXd& points, double amount) const;

 private:
  Eigen::MatrixXd in_own_axes(const Eigen::MatrixXd& points) const;

  Eigen::VectorXd centre_;
  Eigen::MatrixXd axes_;                       ///< principal axes of the points, one a column
  std::vector<ImplicitFunction> coordinates_;  ///< of the displacement, over places in those axes
};

/// Two shapes displaced half-way to each other, as corresponding points ask for, and the way back at any time
/// (appendix, equations 4 and 5): u(x, t) = x + (1 − 2t) w_A(x) up to t = ½, x + (2t − 1) w_B(x) from there, t in
/// [0, 1] from the first shape to the last. A frame is where the morph of the displaced shapes is at u(x, t).
/// Coordinates are those of the shapes: world mm, or slice mm in the first figure's pose.
class HalfwayWarp {
 public:
  /// Throws InputError for other than two shapes that may be morphed, no landmarks, a landmark outside its shape (the
  /// field of view, or a tenth of the diagonal round the shape's box) or off its plane, or one point with two targets;
  /// GeometryError when a displacement folds its shape over.
  HalfwayWarp(const std::vector<KeyShape>& shapes, const std::vector<LandmarkPair>& landmarks);

  /// Images of figures are not displaced: displaced figures have none.
  const std::vector<KeyShape>& displaced_shapes() const { return displaced_; }
  /// u(x, t).
  Eigen::MatrixXd displaced(const Eigen::MatrixXd& points, double t) const;
  std::vector<Eigen::MatrixXd> jacobians(const Eigen::MatrixXd& points, double t) const;
  /// ∂u/∂t.
  Eigen::MatrixXd velocity(const Eigen::MatrixXd& points, double t) const;
  /// The x with u(x, t) = y. Throws GeometryError where space is folded over.
  Eigen::MatrixXd undisplaced(const Eigen::MatrixXd& points, double t) const;
  /// A frame of the displaced shapes' morph, displaced back.
  Shape undisplaced(Shape frame, double t) const;
  /// Where the corresponding points are: n × landmarks; the given ones at 0 and 1, half way at ½.
  Eigen::MatrixXd landmarks_at(double t) const { return undisplaced(halfway_, t); }

 private:
  struct Share;
  Share share_at(double t) const;
  KeyShape displaced(const KeyShape& shape, const Warp& warp) const;

  SlicePose pose_;
  Eigen::Vector2i size_pixels_ = Eigen::Vector2i::Zero();  ///< of the first figure's image
  std::vector<Warp> warps_;                                ///< of the first shape and of the last
  Eigen::MatrixXd halfway_;                                ///< where corresponding points meet
  std::vector<KeyShape> displaced_;
};

/// A morph of any method, guided by corresponding points: `make_morph` morphs the displaced shapes, frames are
/// displaced back. Throws like HalfwayWarp.
Morph warped_morph(const std::vector<KeyShape>& shapes, const std::vector<LandmarkPair>& landmarks,
                   const std::function<Morph(const std::vector<KeyShape>&)>& make_morph);

}  // namespace isostack
