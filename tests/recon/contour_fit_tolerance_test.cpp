// Keeping within a distance of the contours: as smooth as that allows, or with as few constraints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "recon/constraints/refine_samples.h"
#include "recon/geometry/errors.h"
#include "recon/largest_smoothing.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "recon/reconstruct.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::sphere_cuts;

std::vector<Eigen::Vector3d> contour_points_mm(const ContourStack& stack) {
  std::vector<Eigen::Vector3d> points;
  for (const ContourSlice& slice : stack.slices)
    for (const Contour& contour : slice.contours)
      for (const Eigen::Vector2d& p : contour.points_mm) points.push_back(slice.pose.slice_to_world(p));
  return points;
}

double farthest_mm(const ContourStack& stack, const TriangleMesh& surface) {
  const std::vector<double> distances = distances_to_mesh_mm(contour_points_mm(stack), surface);
  return *std::max_element(distances.begin(), distances.end());
}

/// A sphere of radius 30 mm whose contours are off by 0.3 mm (one standard deviation) along their radius.
ContourStack noisy_sphere() {
  ContourStack cuts = sphere_cuts(30, {}, {-25, -20, -15, -10, -5, 0, 5, 10, 15, 20, 25}, 90);
  std::mt19937 random(7);
  std::normal_distribution<double> noise_mm(0, 0.3);
  for (ContourSlice& slice : cuts.slices)
    for (Contour& contour : slice.contours)
      for (Eigen::Vector2d& p : contour.points_mm) p *= 1 + noise_mm(random) / p.norm();
  return cuts;
}

/// Five-pointed stars, 24 mm high, that turn as they rise.
ContourStack stars() {
  ContourStack cuts{.name = "star", .slices = {}};
  for (int s = 0; s < 7; ++s) {
    ContourSlice slice{.name = "slice " + std::to_string(s), .pose = {}, .contours = {Contour{}}};
    slice.pose.origin_mm.z() = 4.0 * s;
    for (int i = 0; i < 240; ++i) {
      const double angle = 2 * std::numbers::pi * i / 240, radius = 25 + 5 * std::cos(5 * (angle + 0.05 * s));
      slice.contours[0].points_mm.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    cuts.slices.push_back(slice);
  }
  return cuts;
}

TEST(Tolerance, SmoothsNoiseAsFarAsItAllows) {
  const ContourStack cuts = noisy_sphere();
  const Reconstruction through = reconstruct(cuts, {});
  const Reconstruction smooth = reconstruct(cuts, {.tolerance_mm = 1});
  EXPECT_LE(smooth.report.contour_residual.largest_mm, 1);
  EXPECT_GT(smooth.report.contour_residual.largest_mm, 0.5) << "smoother was allowed";
  EXPECT_GT(smooth.report.smoothing, 0);
  EXPECT_LE(farthest_mm(cuts, smooth.surface), 1.05);  // the report's distance is to first order
  const double area = 4 * std::numbers::pi * 900;
  EXPECT_LT(std::abs(measure(smooth.surface).area_mm2 - area), std::abs(measure(through.surface).area_mm2 - area) / 2);
}

TEST(Tolerance, ASmallerOneStaysNearer) {
  const Reconstruction near = reconstruct(noisy_sphere(), {.tolerance_mm = 0.4});
  EXPECT_LE(near.report.contour_residual.largest_mm, 0.4);
  EXPECT_GT(near.report.contour_residual.largest_mm, 0.2);
}

TEST(Tolerance, ZeroWithSlicesThatContradictEachOtherIsRefused) {
  ContourStack cuts = sphere_cuts(30, {}, {-20, -10, 0, 10, 20}, 90);
  const SlicePose upright{.x_axis = Eigen::Vector3d::UnitY(), .y_axis = Eigen::Vector3d::UnitZ()};
  for (const ContourSlice& slice : sphere_cuts(33, upright, {0}, 90).slices) cuts.slices.push_back(slice);
  try {
    reconstruct(cuts, {.tolerance_mm = 0});
    FAIL() << "spheres of 30 and 33 mm cannot both be met where the slices cross";
  } catch (const SolveError& error) {
    EXPECT_NE(std::string(error.what()).find("z = "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("--tolerance"), std::string::npos) << error.what();
  }
}

TEST(Tolerance, ZeroWithGoodContoursInterpolates) {
  const Reconstruction r = reconstruct(sphere_cuts(30, {}, {-20, -10, 0, 10, 20}, 90), {.tolerance_mm = 0});
  EXPECT_LT(r.report.contour_residual.largest_mm, 0.1);
  EXPECT_EQ(r.report.smoothing, 0);
}

TEST(Thinning, KeepsWithinTheToleranceWithFarFewerConstraints) {
  const ContourStack cuts = stars();
  const Reconstruction all = reconstruct(cuts, {});
  const Reconstruction few = reconstruct(cuts, {.thin_mm = 0.2});
  EXPECT_LE(few.report.constraints, 0.4 * static_cast<double>(all.report.constraints));
  EXPECT_LE(few.report.contour_residual.largest_mm, 0.2);
  EXPECT_LE(farthest_mm(cuts, few.surface), 0.25);  // the report's distance is to first order
  EXPECT_NEAR(measure(few.surface).volume_mm3, measure(all.surface).volume_mm3,
              0.005 * measure(all.surface).volume_mm3);
}

TEST(Thinning, ResidualIsReportedWithoutIt) {
  const Reconstruction r = reconstruct(stars(), {.max_constraints = 300});
  const ContourResidual& residual = r.report.contour_residual;
  EXPECT_NEAR(residual.largest_mm, farthest_mm(stars(), r.surface), 0.5 * residual.largest_mm);
  EXPECT_LE(residual.mean_mm, residual.percentile95_mm);
  EXPECT_LE(residual.percentile95_mm, residual.largest_mm);
  EXPECT_GT(residual.largest_mm, 0.05) << "300 constraints are too few for stars";
}

TEST(FarthestSamples, AreFarthestFirstAndSpreadOut) {
  const ContourStack cuts = sphere_cuts(30, {}, {0, 10}, 100);
  const std::vector<ContourSample> all = all_samples(cuts);
  ASSERT_EQ(all.size(), 200u);
  Eigen::VectorXd distances = Eigen::VectorXd::Constant(200, 0.05);
  distances[20] = 1, distances[21] = 0.9, distances[60] = 0.5, distances[150] = 2, distances[80] = 3;
  const std::vector<ContourSample> chosen =
      farthest_samples(all, distances, {all[80]}, {.tolerance_mm = 0.1, .spread_mm = 5, .least_spacing_mm = 0.5});
  ASSERT_EQ(chosen.size(), 3u);
  EXPECT_EQ(chosen[0].slice, 1u);
  EXPECT_EQ(chosen[1].point_in_slice_mm, all[20].point_in_slice_mm);
  EXPECT_EQ(chosen[2].point_in_slice_mm, all[60].point_in_slice_mm);
}

TEST(LargestSmoothing, FindsWhereTheDistanceReachesTheTolerance) {
  const auto distance = [](double smoothing) { return 0.1 * std::sqrt(smoothing); };  // 1 mm at ρ = 100
  const double found = largest_smoothing_within(1, {1e-3, 1e6, 1.01}, distance);
  EXPECT_LE(distance(found), 1);
  EXPECT_GE(distance(found), 0.9);
  EXPECT_EQ(largest_smoothing_within(1e-6, {1e-3, 1e6}, distance), 0);
  EXPECT_GT(largest_smoothing_within(1e9, {1e-3, 1e6}, distance), 1e5);
}

}  // namespace
}  // namespace isostack
