#include "segmentation/rasterize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::circle;

Grid oblique_grid() {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Eigen::Vector3d(3, -1, 2).normalized()).toRotationMatrix();
  Grid grid;
  grid.size = {60, 40, 5};
  grid.index_to_world.linear() << 0.7 * turn.col(0), 0.9 * turn.col(1), 4 * turn.col(2);
  grid.index_to_world.translation() = Eigen::Vector3d(-200, 10, 35);
  return grid;
}

ContourStack organ_on(const Grid& grid, int k, std::vector<Contour> contours) {
  ContourStack organ{.name = "organ", .slices = {}};
  organ.slices.push_back({.name = "slice a", .pose = pose_of_plane(grid, k, "g"), .contours = std::move(contours)});
  return organ;
}

std::size_t count_of(const LabelVolume& labels, std::uint16_t label) {
  return static_cast<std::size_t>(std::count(labels.voxels.begin(), labels.voxels.end(), label));
}

Contour rectangle(double left, double top, double right, double bottom) {
  return {.points_mm = {{left, top}, {right, top}, {right, bottom}, {left, bottom}}};
}

TEST(Rasterize, RingOnAnObliqueGridIsTheVoxelsWithinIt) {
  const Eigen::Vector2d middle(20.03, 17.04);
  const std::vector<Contour> ring = {circle(middle, 14, 360), circle(middle, 6, 360, true)};
  LabelVolume labels(oblique_grid(), 9);
  rasterize(organ_on(labels.grid, 3, ring), 2, labels);
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 60; ++i) {
        const double r = (Eigen::Vector2d(0.7 * i, 0.9 * j) - middle).norm();
        const bool near_edge = std::abs(r - 14) < 2e-3 || std::abs(r - 6) < 2e-3;  // polygon against circle
        if (near_edge) continue;
        ASSERT_EQ(labels.at(i, j, k), k == 3 && r < 14 && r > 6 ? 2 : 9) << i << ' ' << j << ' ' << k;
      }
  const double area = std::numbers::pi * (14 * 14 - 6 * 6);
  EXPECT_NEAR(static_cast<double>(count_of(labels, 2)) * 0.7 * 0.9, area, 0.02 * area);
}

TEST(Rasterize, CurvesThroughPixelCentresCountOneOfTwoSides) {
  const Grid oblique = oblique_grid();
  Grid plain;
  plain.size = oblique.size;
  for (const Grid& grid : {plain, oblique}) {
    const double dx = grid.index_to_world.linear().col(0).norm(), dy = grid.index_to_world.linear().col(1).norm();
    LabelVolume labels(grid);
    rasterize(organ_on(grid, 1, {rectangle(2 * dx, 3 * dy, 7 * dx, 9 * dy)}), 1, labels);
    EXPECT_EQ(count_of(labels, 1), 5u * 6);
    rasterize(organ_on(grid, 1, {rectangle(7 * dx, 3 * dy, 10 * dx, 9 * dy)}), 2, labels);
    rasterize(organ_on(grid, 1, {rectangle(2 * dx, 9 * dy, 7 * dx, 12 * dy)}), 3, labels);
    EXPECT_EQ(count_of(labels, 1), 5u * 6) << "neighbours take none of its pixels";
    EXPECT_EQ(count_of(labels, 2), 3u * 6);
    EXPECT_EQ(count_of(labels, 3), 5u * 3);
  }
}

TEST(Rasterize, FindsThePlaneOfASliceWithAnotherRaster) {
  LabelVolume labels(oblique_grid());
  ContourStack organ = organ_on(labels.grid, 2, {rectangle(3.6, 3.8, 10.4, 12.2)});
  SlicePose& pose = organ.slices[0].pose;  // the same plane seen from behind, its origin elsewhere
  const SlicePose old = pose;
  pose.origin_mm = old.slice_to_world({50, -3});
  pose.x_axis = -old.x_axis;
  for (Eigen::Vector2d& p : organ.slices[0].contours[0].points_mm) p = pose.world_to_slice(old.slice_to_world(p));
  rasterize(organ, 1, labels);
  EXPECT_EQ(count_of(labels, 1), 9u * 9);  // columns 5.14…14.86 are 6 to 14, rows 4.2…13.6 are 5 to 13
  EXPECT_EQ(labels.at(6, 5, 2), 1);
  EXPECT_EQ(labels.at(14, 13, 2), 1);
}

TEST(Rasterize, ClipsToTheGridAndSkipsEmptySlices) {
  Grid grid;
  grid.size = {6, 5, 2};
  LabelVolume labels(grid);
  ContourStack organ = organ_on(grid, 0, {rectangle(-50, -50, 2.5, 50)});
  ContourSlice nowhere = organ.slices[0];
  nowhere.contours.clear();
  nowhere.pose.origin_mm.z() = 77;  // off the grid, but says nothing
  organ.slices.push_back(nowhere);
  rasterize(organ, 1, labels);
  EXPECT_EQ(count_of(labels, 1), 3u * 5);
}

TEST(Rasterize, RefusesSlicesOffThePlanes) {
  const Grid grid = oblique_grid();  // planes 4 mm apart
  const auto refused = [&](double off_mm, double turn_rad) {
    ContourStack organ = organ_on(grid, 2, {rectangle(3, 3, 9, 9)});
    SlicePose& pose = organ.slices[0].pose;
    pose.origin_mm += off_mm * pose.normal();
    pose.x_axis = Eigen::AngleAxisd(turn_rad, pose.y_axis) * pose.x_axis;
    LabelVolume labels(grid);
    try {
      rasterize(organ, 1, labels);
    } catch (const GeometryError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("slice a", 0), 0u);
      return true;
    }
    return false;
  };
  EXPECT_FALSE(refused(0, 0));
  EXPECT_FALSE(refused(0.3, 0));  // less than a tenth of 4 mm
  EXPECT_TRUE(refused(0.5, 0));
  EXPECT_TRUE(refused(100, 0));
  EXPECT_TRUE(refused(0, 0.02));
}

}  // namespace
}  // namespace isostack
