#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>
#include <vector>

#include "recon/morphing/shape.h"
#include "recon/morphing/warp.h"

namespace isostack {

enum class TransformKind {
  none,
  rigid,   ///< turn and shift
  affine,  ///< turn, stretch, shear and shift
  warp     ///< through all landmarks (warp.h)
};

/// A family of maps T(x, α) that goes smoothly from the identity at α = 0 to a given map at α = 1 (Breen & Whitaker
/// 2001, eq. 20). The linear part R S (a turn and a symmetric stretch) goes by the turn's angle and by the stretch,
/// about a centre that goes straight: no shape between is smaller than both or turned inside out. A warp's displacement
/// grows in proportion to α. Coordinates: world mm, or slice mm. Points are n × M.
class ShapeTransform {
 public:
  /// The identity at every α.
  ShapeTransform() = default;
  /// x → linear · x + offset; `centre` is the point that moves straight. Throws InputError when the map mirrors or
  /// flattens.
  ShapeTransform(const Eigen::MatrixXd& linear, const Eigen::VectorXd& offset, const Eigen::VectorXd& centre);
  explicit ShapeTransform(Warp warp);

  Eigen::MatrixXd moved(const Eigen::MatrixXd& points, double alpha) const;
  /// The x with T(x, 1) = y. Throws GeometryError where a warp folds space over.
  Eigen::MatrixXd moved_back(const Eigen::MatrixXd& points) const;

  /// A shape under T(·, α), or under T(·, 1)⁻¹. Figures are in the pose that the coordinates are of.
  Shape moved(Shape shape, double alpha) const;
  Shape moved_back(Shape shape) const;

 private:
  struct Affine {
    Eigen::MatrixXd turn, stretch;
    Eigen::VectorXd centre, shift;
    Eigen::MatrixXd linear_at(double alpha) const;
  };
  bool is_identity() const { return std::holds_alternative<std::monostate>(map_); }
  std::vector<Eigen::MatrixXd> jacobians(const Eigen::MatrixXd& points, double alpha) const;

  std::variant<std::monostate, Affine, Warp> map_;
};

/// By landmarks: the map of this kind that takes `from_mm` to `to_mm`, for rigid and affine in the least squares sense
/// (Umeyama 1991); without any: that takes the centre, and with it the principal axes (rigid) or the whole covariance
/// (affine), of one shape to those of the other, each axis the way on which both lean the same way. Shapes that are
/// nearly round have no axes: they are not turned. Figures have the pose `pose` and landmarks lie in its plane.
/// Throws InputError for a warp without landmarks, for landmarks that are too few for the kind, and for mirrored ones.
ShapeTransform transform_between(const KeyShape& from, const KeyShape& to, const SlicePose& pose, TransformKind kind,
                                 const std::vector<LandmarkPair>& landmarks);

}  // namespace isostack
