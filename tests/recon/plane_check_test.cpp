#include "recon/constraints/plane_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::field_of;
using testing_support::sphere_cuts;
using testing_support::sphere_mm;

constexpr double radius_mm = 30;

std::function<Eigen::VectorXd(const Eigen::MatrixXd&)> values_of(std::function<double(const Eigen::Vector3d&)> f) {
  return [field = field_of(std::move(f))](const Eigen::MatrixXd& points) -> Eigen::VectorXd {
    return field.values(points);
  };
}

ContourStack sphere(const std::vector<double>& offsets_mm = {-24, -12, 0, 12, 24}) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  const SlicePose pose{.origin_mm = -64 * (turn.col(0) + turn.col(1)), .x_axis = turn.col(0), .y_axis = turn.col(1)};
  return sphere_cuts(radius_mm, pose, offsets_mm, 360);
}

TEST(PlaneCheck, IsSilentAboutTheRightSurface) {
  const PlaneCheck check = check_planes(values_of([](const auto& p) { return sphere_mm(p, radius_mm); }), sphere());
  EXPECT_GT(check.points, 2000u);
  EXPECT_EQ(check.wrong, 0u);
  EXPECT_TRUE(check.worst.empty());
}

TEST(PlaneCheck, FindsAnExtraPartAndItsDepth) {
  // A ball of 6 mm about (36, 0, 0) of the middle slice: beside the sphere, in its own plane.
  const ContourStack stack = sphere({0});
  const Eigen::Vector3d centre = 36 * stack.slices[0].pose.x_axis;
  const PlaneCheck check = check_planes(
      values_of([&](const auto& p) { return std::max(sphere_mm(p, radius_mm), 6 - (p - centre).norm()); }), stack);
  ASSERT_GT(check.wrong, 0u);
  for (const Disagreement& d : check.worst) {
    EXPECT_LT((d.point_mm - centre).norm(), 6);
    EXPECT_NEAR(d.distance_mm, sphere_mm(d.point_mm, radius_mm), 0.01);  // negative: outside; polygon's sagitta 1 µm
    EXPECT_LT(d.distance_mm, -1);
  }
}

TEST(PlaneCheck, FindsAMissingPart) {
  const ContourStack stack = sphere({-10, 0, 10});
  const Eigen::Vector3d normal = stack.slices[0].pose.normal();
  const PlaneCheck check =
      check_planes(values_of([&](const auto& p) { return p.dot(normal) > 6 ? -1.0 : sphere_mm(p, radius_mm); }), stack);
  ASSERT_GT(check.wrong, 0u);
  for (const Disagreement& d : check.worst) {
    EXPECT_EQ(d.slice, 2u);
    EXPECT_GT(d.distance_mm, 1);
  }
  // The cut at 10 mm has area π (30² − 10²) = 2513 mm², checked on a lattice of 2 mm; its 1 mm rim is tolerated.
  const double rim = std::sqrt(800.0) - 1, expected = 3.14159 * rim * rim / 4;
  EXPECT_NEAR(static_cast<double>(check.wrong), expected, 0.05 * expected);
  EXPECT_NEAR(check.worst.front().distance_mm, std::sqrt(800.0), 1.5) << "the deepest point comes first";
}

TEST(PlaneCheck, FindsWhatNeitherNeighbourShows) {
  const ContourStack stack = sphere({-10, 0, 10});
  const SlicePose& pose = stack.slices[0].pose;
  // Half-way between two slices: a ball of 4 mm far outside both contours, or hollow far inside them.
  for (const double sign : {1.0, -1.0}) {
    const Eigen::Vector3d centre = (sign > 0 ? radius_mm + 10 : 0) * pose.x_axis + 5 * pose.normal();
    const PlaneCheck check =
        check_planes(values_of([&](const auto& p) {
                       const double ball_mm = 4 - (p - centre).norm();
                       const double truth_mm = sphere_mm(p, radius_mm);
                       return sign > 0 ? std::max(truth_mm, ball_mm) : std::min(truth_mm, -ball_mm);
                     }),
                     stack);
    EXPECT_EQ(check.wrong, 0u);
    ASSERT_GT(check.wrong_between, 0u);
    for (const Disagreement& d : check.worst) {
      EXPECT_LT((d.point_mm - centre).norm(), 4);
      EXPECT_LT(d.distance_mm * sign, -5) << "no contour is nearer than half the gap";
    }
  }
}

TEST(PlaneCheck, EmptySlicesMustStayEmptyEvenWhenSlicesAreThin) {
  for (const double gap_mm : {8.0, 1.0}) {
    ContourStack stack = sphere({0, gap_mm});
    stack.slices[1].contours.clear();
    const PlaneCheck check = check_planes(values_of([](const auto& p) { return sphere_mm(p, radius_mm); }), stack);
    ASSERT_GT(check.wrong, 100u) << "gap " << gap_mm;
    for (const Disagreement& d : check.worst) {
      EXPECT_EQ(d.slice, 1u);
      EXPECT_DOUBLE_EQ(d.distance_mm, -gap_mm / 2);
    }
  }
}

TEST(PlaneCheck, SaysNothingOutsideTheImage) {
  ContourStack stack = sphere({0});
  const Eigen::Vector3d centre = 36 * stack.slices[0].pose.x_axis;
  stack.slices[0].size_pixels = {94, 129};  // columns up to 93 mm: 29 mm from the sphere's centre
  const PlaneCheck check = check_planes(
      values_of([&](const auto& p) { return std::max(sphere_mm(p, radius_mm), 6 - (p - centre).norm()); }), stack);
  EXPECT_GT(check.points, 500u);
  EXPECT_EQ(check.wrong, 0u);
}

TEST(PlaneCheck, ToleratesAShiftBelowItsTolerance) {
  const auto swollen = [](double by_mm) {
    return values_of([by_mm](const auto& p) { return sphere_mm(p, radius_mm + by_mm); });
  };
  EXPECT_EQ(check_planes(swollen(0.9), sphere({0})).wrong, 0u);
  EXPECT_GT(check_planes(swollen(3), sphere({0})).wrong, 0u);
  EXPECT_EQ(check_planes(swollen(3), sphere({0}), {.tolerance_pixels = 3.1}).wrong, 0u);
}

TEST(PlaneCheck, KeepsToItsLimits) {
  const auto nowhere = values_of([](const auto&) { return -1.0; });
  const PlaneCheck check = check_planes(nowhere, sphere(), {.max_lattice_points = 900, .max_new_constraints = 5});
  EXPECT_LT(check.points, 1100u);  // the lattice's first row and column come on top
  EXPECT_GT(check.points, 700u);
  EXPECT_EQ(check.worst.size(), 5u);
  for (std::size_t i = 1; i < check.worst.size(); ++i) {
    EXPECT_GE(std::abs(check.worst[i - 1].distance_mm), std::abs(check.worst[i].distance_mm));
    for (std::size_t j = 0; j < i; ++j) {
      if (check.worst[i].slice != check.worst[j].slice) continue;
      EXPECT_GE((check.worst[i].point_mm - check.worst[j].point_mm).norm(), 0.5 * check.worst[j].distance_mm);
    }
  }
}

}  // namespace
}  // namespace isostack
