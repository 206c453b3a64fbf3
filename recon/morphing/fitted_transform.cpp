#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <string>

#include "recon/geometry/errors.h"
#include "recon/morphing/shape_moments.h"
#include "recon/morphing/shape_transform.h"

namespace isostack {

namespace {

constexpr double round_below = 1.1;  // ratio of the variances along two axes

struct PointPairs {
  Eigen::MatrixXd from, to;  ///< n × M
};

PointPairs point_pairs(const std::vector<LandmarkPair>& landmarks, const SlicePose& pose, int n) {
  const auto count = static_cast<Eigen::Index>(landmarks.size());
  PointPairs pairs{Eigen::MatrixXd(n, count), Eigen::MatrixXd(n, count)};
  const auto place = [&](const Eigen::Vector3d& point) -> Eigen::VectorXd {
    if (n == 2) return pose.world_to_slice(point);
    return point;
  };
  for (Eigen::Index i = 0; i < count; ++i) {
    pairs.from.col(i) = place(landmarks[static_cast<std::size_t>(i)].from_mm);
    pairs.to.col(i) = place(landmarks[static_cast<std::size_t>(i)].to_mm);
  }
  if (!pairs.from.allFinite() || !pairs.to.allFinite())
    throw InputError("landmarks", "a coordinate is not a number", "write the landmarks again");
  return pairs;
}

/// Directions in which the points differ.
Eigen::Index rank_of(const Eigen::MatrixXd& points) {
  const Eigen::MatrixXd about_mean = points.colwise() - points.rowwise().mean();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(about_mean);
  const Eigen::VectorXd& widths = svd.singularValues();
  return (widths.array() > 1e-6 * widths.maxCoeff()).count();
}

void require_rank(const PointPairs& pairs, Eigen::Index needed, const std::string& kind) {
  if (pairs.from.cols() > needed && rank_of(pairs.from) >= needed) return;
  throw InputError("landmarks", "they do not determine the " + kind + " transform",
                   "give at least " + std::to_string(needed + 1) + " pairs, not all on one line or plane");
}

ShapeTransform rigid_through(const PointPairs& pairs) {
  require_rank(pairs, pairs.from.rows() - 1, "rigid");
  const Eigen::MatrixXd map = Eigen::umeyama(pairs.from, pairs.to, false);
  const Eigen::Index n = pairs.from.rows();
  return {map.topLeftCorner(n, n), map.topRightCorner(n, 1), pairs.from.rowwise().mean()};
}

ShapeTransform affine_through(const PointPairs& pairs) {
  require_rank(pairs, pairs.from.rows(), "affine");
  const Eigen::VectorXd from = pairs.from.rowwise().mean(), to = pairs.to.rowwise().mean();
  const Eigen::MatrixXd a = pairs.from.colwise() - from, b = pairs.to.colwise() - to;
  const Eigen::MatrixXd linear = a.transpose().colPivHouseholderQr().solve(b.transpose()).transpose();
  return {linear, to - linear * from, from};
}

struct PrincipalAxes {
  Eigen::MatrixXd axes;  ///< a right-handed frame, one a column, each the way the shape leans as far as there is choice
  Eigen::VectorXd variances;  ///< ascending
  bool is_round = false;
};

PrincipalAxes principal_axes(const ShapeMoments& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(moments.covariance);
  PrincipalAxes result{solver.eigenvectors(), solver.eigenvalues(), false};
  for (Eigen::Index i = 1; i < result.variances.size(); ++i)
    result.is_round = result.is_round || result.variances[i] < round_below * result.variances[i - 1];
  return result;
}

/// Turns the target's axes so that both shapes lean the same way along as many as possible, the clearest first; the
/// axis that leans least settles the handedness.
void match_directions(const KeyShape& from, const KeyShape& to, const SlicePose& pose, const ShapeMoments& a,
                      const ShapeMoments& b, PrincipalAxes& from_axes, PrincipalAxes& to_axes) {
  const auto leaning = [&](const KeyShape& shape, const ShapeMoments& moments, const PrincipalAxes& axes) {
    return Eigen::VectorXd(third_moments(shape.shape, pose, moments.centre, axes.axes).array() /
                           axes.variances.array().pow(1.5));
  };
  const Eigen::VectorXd agreement = leaning(from, a, from_axes).cwiseProduct(leaning(to, b, to_axes));
  for (Eigen::Index i = 0; i < agreement.size(); ++i)
    if (agreement[i] < 0) to_axes.axes.col(i) *= -1;
  Eigen::Index least = 0;
  agreement.cwiseAbs().minCoeff(&least);
  if ((to_axes.axes * from_axes.axes.transpose()).determinant() < 0) to_axes.axes.col(least) *= -1;
}

Eigen::MatrixXd root_of(const Eigen::MatrixXd& covariance) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(covariance).operatorSqrt();
}

ShapeTransform by_moments(const KeyShape& from, const KeyShape& to, const SlicePose& pose, TransformKind kind) {
  const ShapeMoments a = moments_of(from.shape, pose), b = moments_of(to.shape, pose);
  const Eigen::Index n = a.centre.size();
  PrincipalAxes from_axes = principal_axes(a), to_axes = principal_axes(b);
  Eigen::MatrixXd linear = Eigen::MatrixXd::Identity(n, n);
  if (kind == TransformKind::affine) linear = root_of(b.covariance) * root_of(a.covariance).inverse();
  if (!from_axes.is_round && !to_axes.is_round) {
    match_directions(from, to, pose, a, b, from_axes, to_axes);
    const Eigen::VectorXd stretch = (to_axes.variances.array() / from_axes.variances.array()).sqrt();
    linear = kind == TransformKind::affine
                 ? Eigen::MatrixXd(to_axes.axes * stretch.asDiagonal() * from_axes.axes.transpose())
                 : Eigen::MatrixXd(to_axes.axes * from_axes.axes.transpose());
  }
  return {linear, b.centre - linear * a.centre, a.centre};
}

}  // namespace

ShapeTransform transform_between(const KeyShape& from, const KeyShape& to, const SlicePose& pose, TransformKind kind,
                                 const std::vector<LandmarkPair>& landmarks) {
  if (kind == TransformKind::none) return {};
  if (landmarks.empty()) {
    if (kind == TransformKind::warp)
      throw InputError("landmarks", "a warp needs them, but there are none",
                       "give pairs of points, or another transform");
    return by_moments(from, to, pose, kind);
  }
  const PointPairs pairs = point_pairs(landmarks, pose, dimension_of(from.shape));
  if (kind == TransformKind::rigid) return rigid_through(pairs);
  if (kind == TransformKind::affine) return affine_through(pairs);
  return ShapeTransform(Warp(pairs.from, pairs.to - pairs.from));
}

}  // namespace isostack
