#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/geometry/pixel_lattice.h"
#include "recon/morphing/densified.h"
#include "recon/morphing/warp.h"

namespace isostack {

namespace {

constexpr double outside_share = 0.1;      // of the box's diagonal: landmarks may lie this far round it
constexpr double off_plane_pixels = 0.01;  // rounded coordinates in files
constexpr double same_point = 1e-6;        // of the box's diagonal
constexpr double curve_step_pixels = 0.25;

template <int N>
Eigen::MatrixXd as_columns(const std::vector<Eigen::Matrix<double, N, 1>>& points) {
  Eigen::MatrixXd columns(N, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = points[i];
  return columns;
}

template <int N, class Move>
void move_all(std::vector<Eigen::Matrix<double, N, 1>>& points, Move move) {
  const Eigen::MatrixXd moved = move(as_columns(points));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = moved.col(static_cast<Eigen::Index>(i));
}

std::string landmark(Eigen::Index number) { return fmt::format("landmark {}", number + 1); }

/// In the shapes' coordinates.
Eigen::VectorXd place_of(const Eigen::Vector3d& point_mm, int dimension, const SlicePose& pose) {
  if (dimension == 2) return pose.world_to_slice(point_mm);
  return point_mm;
}

bool is_within_image(const Shape& shape, const Eigen::Vector3d& point_mm) {
  const auto* figure = std::get_if<ContourSlice>(&shape);
  if (figure == nullptr || figure->size_pixels.minCoeff() <= 0) return false;
  const Eigen::Vector2d pixel = figure->pose.slice_to_pixel(figure->pose.world_to_slice(point_mm));
  return pixel.minCoeff() >= -0.5 && (pixel.array() <= figure->size_pixels.cast<double>().array() - 0.5).all();
}

void require_near(const KeyShape& shape, const SlicePose& pose, const Eigen::Vector3d& point_mm, Eigen::Index number) {
  if (!point_mm.allFinite())
    throw InputError(landmark(number), "a coordinate is not a number", "write the landmarks again");
  const int dimension = dimension_of(shape.shape);
  const Eigen::AlignedBox3d box = box_of(shape.shape, pose);
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  place.head(dimension) = place_of(point_mm, dimension, pose);
  const double off_plane_mm = dimension == 2 ? std::abs(pose.signed_distance_mm(point_mm)) : 0;
  if (off_plane_mm > off_plane_pixels * pose.spacing_mm.minCoeff())
    throw InputError(landmark(number), fmt::format("it is {:.3g} mm off the plane of {}", off_plane_mm, shape.name),
                     "give points in the figures' plane, in world mm");
  if (!is_within_image(shape.shape, point_mm) && box.exteriorDistance(place) > outside_share * box.diagonal().norm())
    throw InputError(landmark(number),
                     fmt::format("it is {:.4g} mm outside the box round {}", box.exteriorDistance(place), shape.name),
                     "give points on the shapes, in world mm");
}

void require_one_target(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to, double same_mm) {
  for (Eigen::Index i = 0; i < from.cols(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if (((from.col(i) - from.col(j)).norm() < same_mm) != ((to.col(i) - to.col(j)).norm() < same_mm))
        throw InputError(landmark(i),
                         fmt::format("it is the same point as {} in one shape, but not in the other", landmark(j)),
                         "give every point one partner");
}

/// Each distinct point once, so that the displacements are determined.
std::vector<Eigen::Index> distinct(const Eigen::MatrixXd& points, double same_mm) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](auto j) { return (points.col(i) - points.col(j)).norm() < same_mm; }))
      kept.push_back(i);
  return kept;
}

/// Looks at a lattice over the shape's box, all the way of the displacement.
void require_no_fold(const KeyShape& shape, const SlicePose& pose, const Warp& warp) {
  constexpr int nodes = 16;
  const int dimension = dimension_of(shape.shape);
  const Eigen::AlignedBox3d box = box_of(shape.shape, pose);
  Eigen::MatrixXd lattice(dimension, dimension == 2 ? nodes * nodes : nodes * nodes * nodes);
  for (Eigen::Index i = 0; i < lattice.cols(); ++i)
    for (int axis = 0, rest = static_cast<int>(i); axis < dimension; ++axis, rest /= nodes)
      lattice(axis, i) = box.min()[axis] + box.sizes()[axis] * (rest % nodes) / (nodes - 1);
  for (const double amount : {0.25, 0.5, 0.75, 1.0})
    for (const Eigen::MatrixXd& slope : warp.jacobians(lattice, amount))
      if (!(slope.determinant() > 0))
        throw GeometryError(shape.name, "the displacement that the landmarks ask for folds it over",
                            "move the landmarks so that they keep their order, or use fewer");
}

}  // namespace

/// Which displacement holds at a time, and how much of it.
struct HalfwayWarp::Share {
  const Warp& warp;
  double amount;
  double rate;  ///< of the amount with t
};

HalfwayWarp::Share HalfwayWarp::share_at(double t) const {
  if (t <= 0.5) return {warps_.front(), 1 - 2 * t, -2};
  return {warps_.back(), 2 * t - 1, 2};
}

HalfwayWarp::HalfwayWarp(const std::vector<KeyShape>& shapes, const std::vector<LandmarkPair>& landmarks) {
  require_morphable(shapes);
  if (shapes.size() != 2)
    throw InputError("landmarks", fmt::format("they join two shapes, but there are {}", shapes.size()),
                     "morph two shapes at a time, or leave the landmarks out");
  if (landmarks.empty()) throw InputError("landmarks", "there are none", "give at least one pair of points");
  pose_ = common_pose(shapes);
  if (const auto* figure = std::get_if<ContourSlice>(&shapes.front().shape)) size_pixels_ = figure->size_pixels;
  const int dimension = dimension_of(shapes.front().shape);
  const auto count = static_cast<Eigen::Index>(landmarks.size());
  Eigen::MatrixXd from(dimension, count), to(dimension, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const LandmarkPair& pair = landmarks[static_cast<std::size_t>(i)];
    require_near(shapes.front(), pose_, pair.from_mm, i);
    require_near(shapes.back(), pose_, pair.to_mm, i);
    from.col(i) = place_of(pair.from_mm, dimension, pose_);
    to.col(i) = place_of(pair.to_mm, dimension, pose_);
  }
  const double same_mm = same_point * box_of(shapes).diagonal().norm();
  require_one_target(from, to, same_mm);
  halfway_ = (from + to) / 2;
  const std::vector<Eigen::Index> kept = distinct(from, same_mm);
  const Eigen::MatrixXd a = from(Eigen::all, kept), b = to(Eigen::all, kept);
  warps_ = {Warp(a, (b - a) / 2), Warp(b, (a - b) / 2)};
  for (std::size_t i = 0; i < 2; ++i) {
    require_no_fold(shapes[i], pose_, warps_[i]);
    displaced_.push_back(displaced(shapes[i], warps_[i]));
  }
}

KeyShape HalfwayWarp::displaced(const KeyShape& shape, const Warp& warp) const {
  KeyShape result = shape;
  result.image.reset();
  if (auto* mesh = std::get_if<TriangleMesh>(&result.shape)) {
    move_all(mesh->vertices_mm, [&](const Eigen::MatrixXd& points) { return warp.displaced(points, 1); });
    mesh->normals.clear();
    return result;
  }
  auto& figure = std::get<ContourSlice>(result.shape);
  const double step_mm = curve_step_pixels * figure.pose.spacing_mm.minCoeff();
  figure.contours = densified(moved_to(pose_, figure.contours, figure.pose), step_mm);  // straight edges will bend
  figure.pose = pose_;
  figure.size_pixels.setZero();  // it may leave its image
  for (Contour& contour : figure.contours)
    move_all(contour.points_mm, [&](const Eigen::MatrixXd& points) { return warp.displaced(points, 1); });
  return result;
}

Eigen::MatrixXd HalfwayWarp::displaced(const Eigen::MatrixXd& points, double t) const {
  const Share share = share_at(t);
  return share.warp.displaced(points, share.amount);
}

std::vector<Eigen::MatrixXd> HalfwayWarp::jacobians(const Eigen::MatrixXd& points, double t) const {
  const Share share = share_at(t);
  return share.warp.jacobians(points, share.amount);
}

Eigen::MatrixXd HalfwayWarp::velocity(const Eigen::MatrixXd& points, double t) const {
  const Share share = share_at(t);
  return share.rate * (share.warp.displaced(points, 1) - points);
}

Eigen::MatrixXd HalfwayWarp::undisplaced(const Eigen::MatrixXd& points, double t) const {
  const Share share = share_at(t);
  return share.warp.undisplaced(points, share.amount);
}

Shape HalfwayWarp::undisplaced(Shape frame, double t) const {
  const auto move = [&](const Eigen::MatrixXd& points) { return undisplaced(points, t); };
  if (auto* figure = std::get_if<ContourSlice>(&frame)) {
    figure->size_pixels = size_pixels_;
    for (Contour& contour : figure->contours) move_all(contour.points_mm, move);
    return frame;
  }
  auto& mesh = std::get<TriangleMesh>(frame);
  if (mesh.vertices_mm.empty()) return frame;
  move_all(mesh.vertices_mm, move);
  if (mesh.normals.empty()) return frame;
  const std::vector<Eigen::MatrixXd> slopes = jacobians(as_columns(mesh.vertices_mm), t);
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)  // ∇(F ∘ u) = Jᵀ ∇F
    mesh.normals[i] = (slopes[i].transpose() * mesh.normals[i]).normalized();
  return frame;
}

}  // namespace isostack
