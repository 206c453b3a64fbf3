#include "recon/morphing/shape_transform.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "recon/geometry/errors.h"
#include "recon/morphing/shape_moments.h"
#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

constexpr double rounding = 1e-9;

/// A box with the corner at the origin cut off beyond its middle: it leans along every axis.
KeyShape leaning_body() {
  TriangleMesh mesh = testing_support::box_mesh({0, 0, 0}, {10, 20, 40});
  mesh.vertices_mm[0] = {4, 7, 13};
  return {.name = "leaning", .shape = mesh};
}

TEST(ShapeMoments, OfABoxAreThoseOfTheClosedForm) {
  const ShapeMoments box = moments_of(testing_support::box_mesh({100, 200, 300}, {110, 220, 340}), {});
  EXPECT_NEAR(box.content, 8000, 8000 * rounding);
  EXPECT_LT((box.centre - Eigen::Vector3d(105, 210, 320)).norm(), 1e-6);
  const Eigen::Matrix3d truth = Eigen::Vector3d(100, 400, 1600).asDiagonal() * Eigen::Matrix3d::Identity() / 12;
  EXPECT_LT((box.covariance - truth).norm(), 1e-6);
}

TEST(ShapeMoments, ThirdMomentOfATriangleIsTheClosedForm) {
  ContourSlice slice;
  slice.contours = {Contour{.points_mm = {{0, 0}, {1, 0}, {0, 1}}}};
  // ∫ (x - 1/3)³ 2 (1 - x) dx from 0 to 1 = 1/135.
  const Eigen::VectorXd third =
      third_moments(slice, slice.pose, Eigen::Vector2d(1. / 3, 1. / 3), Eigen::Matrix2d::Identity());
  EXPECT_NEAR(third[0], 1. / 135, rounding);
  EXPECT_NEAR(third[1], 1. / 135, rounding);
}

TEST(ShapeTransform, GoesFromTheIdentityToTheMapAndBack) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3d linear = turn * Eigen::Vector3d(1, 2, 0.5).asDiagonal();
  const Eigen::Vector3d offset(5, -7, 9);
  const ShapeTransform transform(linear, offset, Eigen::Vector3d(1, 1, 1));
  const Eigen::MatrixXd points = Eigen::MatrixXd::Random(3, 20) * 10;
  EXPECT_LT((transform.moved(points, 0) - points).norm(), rounding);
  EXPECT_LT((transform.moved(points, 1) - ((linear * points).colwise() + offset)).norm(), rounding);
  EXPECT_LT((transform.moved_back(transform.moved(points, 1)) - points).norm(), 1e-8);
}

TEST(ShapeTransform, TurnsAtAConstantRateAndKeepsItsSize) {
  const Eigen::Matrix2d half_turn = -Eigen::Matrix2d::Identity();
  const ShapeTransform transform(half_turn, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  for (const double alpha : {0.25, 0.5, 0.75})
    EXPECT_NEAR(transform.moved(Eigen::MatrixXd(Eigen::Vector2d(3, 4)), alpha).norm(), 5, rounding);
}

TEST(ShapeTransform, MirrorsAreRefused) {
  const Eigen::Matrix2d mirror = Eigen::Vector2d(1, -1).asDiagonal() * Eigen::Matrix2d::Identity();
  EXPECT_THROW(ShapeTransform(mirror, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()), InputError);
}

TEST(ShapeTransform, MomentsFindTheMotionOfABody) {
  const KeyShape body = leaning_body();
  Eigen::Isometry3d motion =
      Eigen::Translation3d(30, -20, 10) * Eigen::AngleAxisd(2.5, Eigen::Vector3d(3, 1, 2).normalized());
  const KeyShape there{.name = "there", .shape = testing_support::moved(std::get<TriangleMesh>(body.shape), motion)};
  for (const TransformKind kind : {TransformKind::rigid, TransformKind::affine}) {
    const auto found = std::get<TriangleMesh>(transform_between(body, there, {}, kind, {}).moved(body.shape, 1));
    for (std::size_t i = 0; i < found.vertices_mm.size(); ++i)
      EXPECT_LT((found.vertices_mm[i] - std::get<TriangleMesh>(there.shape).vertices_mm[i]).norm(), 1e-6);
  }
}

TEST(ShapeTransform, LandmarksFindTheMotion) {
  const Eigen::Isometry3d motion = Eigen::Translation3d(3, 2, 1) * Eigen::AngleAxisd(1, Eigen::Vector3d::UnitY());
  std::vector<LandmarkPair> landmarks;
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(9, 0, 0), Eigen::Vector3d(0, 9, 0),
                                   Eigen::Vector3d(0, 0, 9), Eigen::Vector3d(5, 6, 7)})
    landmarks.push_back({p, motion * p});
  const KeyShape body = leaning_body();
  const Eigen::MatrixXd points = Eigen::MatrixXd::Random(3, 10) * 10;
  for (const TransformKind kind : {TransformKind::rigid, TransformKind::affine, TransformKind::warp}) {
    const ShapeTransform found = transform_between(body, body, {}, kind, landmarks);
    const Eigen::MatrixXd truth = (motion.linear() * points).colwise() + motion.translation();
    EXPECT_LT((found.moved(points, 1) - truth).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace isostack
