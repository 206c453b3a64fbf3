#include "recon/morphing/shape_transform.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/morphing/densified.h"

namespace isostack {

namespace {

Eigen::MatrixXd as_columns(const std::vector<Eigen::Vector3d>& points) {
  return Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, static_cast<Eigen::Index>(points.size()));
}

/// move: a matrix of points -> a matrix of points.
template <class Point, class Move>
void move_all(std::vector<Point>& points, const Move& move) {
  constexpr int n = Point::RowsAtCompileTime;
  if (points.empty()) return;
  Eigen::Map<Eigen::Matrix<double, n, Eigen::Dynamic>> columns(points.front().data(), n,
                                                               static_cast<Eigen::Index>(points.size()));
  columns = move(Eigen::MatrixXd(columns));
}

template <class Move>
Shape with_points_moved(Shape shape, const Move& move) {
  if (auto* mesh = std::get_if<TriangleMesh>(&shape)) move_all(mesh->vertices_mm, move);
  if (auto* figure = std::get_if<ContourSlice>(&shape)) {
    figure->contours = densified(std::move(figure->contours), 0.5 * figure->pose.spacing_mm.minCoeff());  // may bend
    for (Contour& contour : figure->contours) move_all(contour.points_mm, move);
  }
  return shape;
}

/// The turn by the share `alpha` of its angle.
Eigen::MatrixXd part_of_turn(const Eigen::MatrixXd& turn, double alpha) {
  if (turn.rows() == 2)
    return Eigen::Rotation2Dd(alpha * Eigen::Rotation2Dd(Eigen::Matrix2d(turn)).smallestAngle()).toRotationMatrix();
  const Eigen::AngleAxisd whole{Eigen::Matrix3d(turn)};
  return Eigen::AngleAxisd(alpha * whole.angle(), whole.axis()).toRotationMatrix();
}

}  // namespace

ShapeTransform::ShapeTransform(const Eigen::MatrixXd& linear, const Eigen::VectorXd& offset,
                               const Eigen::VectorXd& centre) {
  constexpr double flat = 1e-6;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd& widths = svd.singularValues();
  if (!(linear.determinant() > 0) || widths.minCoeff() < flat * widths.maxCoeff())
    throw InputError("transform", "it mirrors space or makes it flat", "check the order of the landmarks");
  map_ = Affine{.turn = svd.matrixU() * svd.matrixV().transpose(),
                .stretch = svd.matrixV() * widths.asDiagonal() * svd.matrixV().transpose(),
                .centre = centre,
                .shift = linear * centre + offset - centre};
}

ShapeTransform::ShapeTransform(Warp warp) : map_(std::move(warp)) {}

Eigen::MatrixXd ShapeTransform::Affine::linear_at(double alpha) const {
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(stretch.rows(), stretch.cols());
  return part_of_turn(turn, alpha) * (identity + alpha * (stretch - identity));
}

Eigen::MatrixXd ShapeTransform::moved(const Eigen::MatrixXd& points, double alpha) const {
  if (const auto* warp = std::get_if<Warp>(&map_)) return warp->displaced(points, alpha);
  const auto* affine = std::get_if<Affine>(&map_);
  if (affine == nullptr) return points;
  const Eigen::VectorXd there = affine->centre + alpha * affine->shift;
  return (affine->linear_at(alpha) * (points.colwise() - affine->centre)).colwise() + there;
}

Eigen::MatrixXd ShapeTransform::moved_back(const Eigen::MatrixXd& points) const {
  if (const auto* warp = std::get_if<Warp>(&map_)) return warp->undisplaced(points, 1);
  const auto* affine = std::get_if<Affine>(&map_);
  if (affine == nullptr) return points;
  const Eigen::MatrixXd back = affine->linear_at(1).inverse();
  const Eigen::VectorXd there = affine->centre + affine->shift;
  return (back * (points.colwise() - there)).colwise() + affine->centre;
}

std::vector<Eigen::MatrixXd> ShapeTransform::jacobians(const Eigen::MatrixXd& points, double alpha) const {
  if (const auto* warp = std::get_if<Warp>(&map_)) return warp->jacobians(points, alpha);
  return std::vector<Eigen::MatrixXd>(static_cast<std::size_t>(points.cols()), std::get<Affine>(map_).linear_at(alpha));
}

Shape ShapeTransform::moved(Shape shape, double alpha) const {
  if (is_identity() || alpha == 0) return shape;
  auto* mesh = std::get_if<TriangleMesh>(&shape);
  if (mesh != nullptr && !mesh->normals.empty()) {
    const std::vector<Eigen::MatrixXd> slopes = jacobians(as_columns(mesh->vertices_mm), alpha);
    for (std::size_t i = 0; i < mesh->normals.size(); ++i)
      mesh->normals[i] = Eigen::Matrix3d(slopes[i]).inverse().transpose() * mesh->normals[i];
    for (Eigen::Vector3d& normal : mesh->normals) normal.normalize();
  }
  return with_points_moved(std::move(shape), [&](const Eigen::MatrixXd& points) { return moved(points, alpha); });
}

Shape ShapeTransform::moved_back(Shape shape) const {
  if (is_identity()) return shape;
  if (auto* mesh = std::get_if<TriangleMesh>(&shape)) mesh->normals.clear();
  return with_points_moved(std::move(shape), [&](const Eigen::MatrixXd& points) { return moved_back(points); });
}

}  // namespace isostack
