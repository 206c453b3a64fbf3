#include "recon/predicted_memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "recon/geometry/errors.h"
#include "recon/solvers/fast_sum.h"
#include "recon/solvers/product_memory.h"
#include "recon/surface_estimate.h"

namespace isostack {
namespace {

constexpr double radius_mm = 40;
constexpr double sphere_area_mm2 = 4 * std::numbers::pi * radius_mm * radius_mm;

SlicePose plane_at(double place_mm, bool upright) {
  SlicePose pose;
  pose.origin_mm = upright ? Eigen::Vector3d(place_mm, 0, 0) : Eigen::Vector3d(0, 0, place_mm);
  if (upright) {
    pose.x_axis = Eigen::Vector3d::UnitY();
    pose.y_axis = Eigen::Vector3d::UnitZ();
  }
  return pose;
}

/// A sphere about the world's origin, cut every `gap_mm`.
ContourStack sphere(double gap_mm, bool upright = false) {
  ContourStack stack;
  stack.name = "sphere";
  for (double place_mm = gap_mm / 2 - radius_mm; place_mm < radius_mm; place_mm += gap_mm) {
    const double r = std::sqrt(radius_mm * radius_mm - place_mm * place_mm);
    Contour circle;
    for (int i = 0; i < 100; ++i)
      circle.points_mm.emplace_back(r * std::cos(std::numbers::pi * i / 50), r * std::sin(std::numbers::pi * i / 50));
    ContourSlice slice;
    slice.pose = plane_at(place_mm, upright);
    slice.contours.push_back(circle);
    stack.slices.push_back(slice);
  }
  return stack;
}

TEST(SurfaceEstimate, IsASpheresArea) {
  // Bands between slices are cones; the flat ends make up for the caps.
  EXPECT_NEAR(estimated_area_mm2(sphere(4)), sphere_area_mm2, 0.03 * sphere_area_mm2);
  EXPECT_NEAR(estimated_area_mm2(sphere(10, true)), sphere_area_mm2, 0.05 * sphere_area_mm2);
}

TEST(SurfaceEstimate, OfCrossingSlicesIsTheirBoxesEllipsoidAtLeast) {
  ContourStack crossing = sphere(2 * radius_mm);  // one slice through the centre
  crossing.slices.push_back(sphere(2 * radius_mm, true).slices.front());
  EXPECT_NEAR(estimated_area_mm2(crossing), sphere_area_mm2, 0.03 * sphere_area_mm2);
}

TEST(ProductMemory, IsWhatASumHolds) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points(3, 20'000);  // on a sphere, as constraints lie on a surface
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points.col(i) = radius_mm * Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  const FastSumOptions options{.far_field = {.order = 7, .order_growth = 2, .most_order = 20}};
  FastSum sum({triharmonic(), 0}, points, options);
  sum.values(Eigen::VectorXd::Ones(points.cols()));
  const Octree tree(points, OctreeDomain::fitted(points, 1e-4, options.leaf_size), options.leaf_size);
  const ProductMemory memory = product_memory(tree, options.far_field);
  const double predicted = static_cast<double>(memory.sources + memory.targets);
  // Lists of cells are estimated, not counted.
  EXPECT_NEAR(predicted, static_cast<double>(sum.bytes()), 0.25 * predicted);
}

TEST(PredictMemory, GrowsWithWhatIsSolvedForAndHeld) {
  const std::vector<ContourStack> stacks{sphere(2)};
  ReconstructOptions options;
  options.max_constraints = 600;
  const MemoryPrediction few = predict_memory(stacks, options, 0);
  options.max_constraints = 6000;
  const MemoryPrediction many = predict_memory(stacks, options, 0);
  EXPECT_LE(few.organs[0].constraints, 600U);
  EXPECT_GT(many.organs[0].constraints, 3000U);
  EXPECT_GT(many.process_bytes, few.process_bytes);
  EXPECT_EQ(predict_memory(stacks, options, 1'000'000).process_bytes, many.process_bytes + 1'000'000);
  const double cells = 1.5 * sphere_area_mm2;  // of 1 mm, averaged over all directions
  EXPECT_NEAR(static_cast<double>(many.organs[0].cells), cells, 0.15 * cells);
}

TEST(PredictMemory, KeepsTheFunctionsOfOrgansThatMayOverlap) {
  const ContourStack one = sphere(2);
  ReconstructOptions options;
  options.max_constraints = 6000;
  const std::size_t alone = predict_memory({one}, options, 0).process_bytes;
  EXPECT_GT(predict_memory({one, one}, options, 0).process_bytes, alone);
}

TEST(PredictMemory, RefusesAsTheSolveWould) {
  ReconstructOptions options;
  options.memory_limit_bytes = 1'000'000;
  EXPECT_THROW(predict_memory({sphere(2)}, options, 0), SolveError);
  EXPECT_THROW(predict_memory({sphere(70)}, ReconstructOptions{}, 0), GeometryError);
}

}  // namespace
}  // namespace isostack
