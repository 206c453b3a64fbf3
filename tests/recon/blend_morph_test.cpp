#include "recon/morphing/blend_morph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recon/functions/r_functions.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/frame_quality.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/morphing/frame_components.h"
#include "tests/support/figures.h"
#include "tests/support/morph_meshes.h"

namespace isostack {
namespace {

using testing_support::contours_of;
using testing_support::disc;
using testing_support::figure;
using testing_support::largest_distance;

/// The paper's Figure 2.
std::vector<KeyShape> discs_and_cross() {
  const KeyShape discs = figure("discs", 100, [](const Eigen::Vector2d& p) {
    return 20 - std::min((p - Eigen::Vector2d(27, 50)).norm(), (p - Eigen::Vector2d(73, 50)).norm());
  });
  const KeyShape cross = figure("cross", 100, [](const Eigen::Vector2d& q) {
    const Eigen::Vector2d p = (q - Eigen::Vector2d(50, 50)).cwiseAbs();
    return std::max(std::min(43 - p.x(), 12 - p.y()), std::min(12 - p.x(), 43 - p.y()));
  });
  return {discs, cross};
}

std::vector<double> areas_of(const std::vector<Shape>& frames) {
  std::vector<double> areas;
  for (const Shape& frame : frames) areas.push_back(frame_quality(frame).content);
  return areas;
}

double largest_change(const std::vector<double>& areas) {
  double largest = 0;
  for (std::size_t i = 1; i < areas.size(); ++i) largest = std::max(largest, std::abs(areas[i] - areas[i - 1]));
  return largest;
}

BlendMorphOptions coarse(HalfCylinderEnds ends) {
  BlendMorphOptions options;
  options.ends = ends;
  options.resolution_mm = 2;
  return options;
}

TEST(BlendMorph, SmoothedEndsTakeTheJumpOutOfDiscsToCross) {
  const auto smoothed = areas_of(blend_morph(discs_and_cross(), coarse(HalfCylinderEnds::smoothed)).frames(41));
  const auto flat = areas_of(blend_morph(discs_and_cross(), coarse(HalfCylinderEnds::flat)).frames(41));
  EXPECT_GT(largest_change(flat), 3 * largest_change(smoothed));  // measured: 5 times
  EXPECT_LT(largest_change(smoothed), 0.2 * smoothed.back());
}

/// Thin figures want their ends tapered by more than their own thickness.
TEST(BlendMorph, ThinFiguresTaperWithAWiderSmoothing) {
  const std::vector<KeyShape> shapes{testing_support::x_figure(), testing_support::o_figure()};  // bars of 16 mm
  BlendMorphOptions options = coarse(HalfCylinderEnds::smoothed);
  options.smoothing = BlendParameters{.a0 = 11, .a1 = 1, .a2 = 1, .a3 = 1};
  const auto smoothed = areas_of(blend_morph(shapes, options).frames(41));
  const auto flat = areas_of(blend_morph(shapes, coarse(HalfCylinderEnds::flat)).frames(41));
  EXPECT_GT(largest_change(flat), 3 * largest_change(smoothed));  // measured: 4 times; 2 by default
}

TEST(BlendMorph, EndFramesAreTheGivenShapesAndNoneBetweenIsEmpty) {
  const std::vector<KeyShape> shapes = discs_and_cross();
  const auto frames = blend_morph(shapes, coarse(HalfCylinderEnds::smoothed)).frames(21);
  EXPECT_LT(largest_distance(contours_of(frames.front()), contours_of(shapes.front().shape)), 1e-6);
  EXPECT_LT(largest_distance(contours_of(frames.back()), contours_of(shapes.back().shape)), 1e-6);
  const FrameComponents components = frame_components(frames, shapes);
  EXPECT_EQ(components.counts.front(), 2u);
  EXPECT_EQ(components.counts.back(), 1u);
  EXPECT_TRUE(components.stray.empty());
  const auto areas = areas_of(frames);
  EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 0.5 * areas.front());  // 0.6 on the lattice looked at
}

TEST(BlendMorph, DisjointShapesOfAnySizeKeepTheirContent) {
  for (const double scale : {0.02, 1.0}) {  // a0 … a3 go with the size
    std::vector<KeyShape> shapes{disc("a", {20, 50}, 15), disc("b", {75, 40}, 20)};
    for (KeyShape& shape : shapes) {
      auto& slice = std::get<ContourSlice>(shape.shape);
      slice.pose.spacing_mm.setConstant(scale);
      for (Eigen::Vector2d& p : slice.contours.front().points_mm) p *= scale;
    }
    const auto areas = areas_of(blend_morph(shapes, {.resolution_mm = 2 * scale}).frames(11));
    for (const double area : areas) {
      EXPECT_GT(area, 0.5 * areas.front());
      EXPECT_LT(area, 1.5 * areas.back());
    }
  }
}

TEST(BlendMorph, OutsideTheSlabFramesAreTheShapesAndWithinItTheBlend) {
  const std::vector<KeyShape> shapes{disc("a", {35, 50}, 15), disc("b", {60, 50}, 25), disc("c", {50, 50}, 10)};
  BlendMorphOptions options = coarse(HalfCylinderEnds::smoothed);
  options.slab = {.from = 0.2, .to = 0.6};
  const Morph morph = blend_morph(shapes, options);
  const auto off = [&](double t, int shape) {
    return largest_distance(contours_of(morph.shape_at(t)), contours_of(shapes[static_cast<std::size_t>(shape)].shape));
  };
  EXPECT_LT(off(0.1, 0), 1e-6);  // t runs over two ways: a fifth and three fifths of the first are 0.1 and 0.3
  EXPECT_LT(off(0.3, 1), 1e-6);
  EXPECT_LT(off(0.5, 1), 1e-6);
  EXPECT_LT(off(0.8, 2), 1e-6);
  EXPECT_GT(off(0.2, 0), 1);
  EXPECT_GT(off(0.2, 1), 1);
  const auto field = morph.spacetime();
  ASSERT_TRUE(field);
  Eigen::Matrix3Xd centres(3, 3);
  centres << 35, 60, 50, 50, 50, 50, 0, 0.5 * field->bounds_mm.max().z(), field->bounds_mm.max().z();
  EXPECT_GT(field->field.values(centres).minCoeff(), 0);
}

TEST(BlendMorph, ACubeMeltsIntoATorusAndAPullGoesAsFarAsItsTime) {
  const KeyShape cube{.name = "cube", .shape = testing_support::box_mesh({-28, -28, -28}, {28, 28, 28})};
  TriangleMesh rings = testing_support::torus_mesh(30, 8, 48, 16);
  for (Eigen::Vector3d& v : rings.vertices_mm) v.x() += 100;
  const std::vector<KeyShape> shapes{cube, {.name = "torus", .shape = rings}};
  BlendMorphOptions options;
  options.resolution_mm = 5;
  const auto frames = blend_morph(shapes, options).frames(5);
  for (const Shape& frame : frames) {
    const MeshMeasures body = measure(std::get<TriangleMesh>(frame));
    EXPECT_TRUE(body.watertight());
    EXPECT_GT(body.volume_mm3, 0.5 * measure(rings).volume_mm3);
  }
  EXPECT_EQ(measure(std::get<TriangleMesh>(frames.front())).volume_mm3, 56.0 * 56 * 56);
  EXPECT_EQ(measure(std::get<TriangleMesh>(frames.back())).genus, 1);
  options.slab = {.from = 0.3, .to = 1};
  options.deformations = {{.key = 0, .from_mm = Eigen::Vector3d(28, 0, 0), .to_mm = Eigen::Vector3d(80, 0, 0)}};
  const Shape pulled = blend_morph(shapes, options).shape_at(0.3);
  double reach = 0;
  for (const Eigen::Vector3d& v : std::get<TriangleMesh>(pulled).vertices_mm) reach = std::max(reach, v.x());
  EXPECT_NEAR(reach, 28 + 52 * (0.75 * 0.75 * (3 - 1.5)), 1);  // the smooth step at 3/4; a fifth of a cell
}

TEST(BlendMorph, BoundsOfSpaceTimeKeepTheBlendWithinThem) {
  const std::vector<KeyShape> shapes{disc("a", {35, 50}, 15), disc("b", {65, 50}, 15)};
  BlendMorphOptions options = coarse(HalfCylinderEnds::flat);
  options.bounds = [](const Eigen::MatrixXd& points) -> Eigen::ArrayXd {
    return 52 - points.row(1).transpose().array();  // y below 52
  };
  const auto frames = blend_morph(shapes, options).frames(9);
  for (const Shape& frame : frames)
    for (const Contour& contour : contours_of(frame))
      for (const Eigen::Vector2d& p : contour.points_mm)
        if (p.y() > 52.5) {  // nothing is added there: only the discs themselves
          EXPECT_LT(std::min((p - Eigen::Vector2d(35, 50)).norm(), (p - Eigen::Vector2d(65, 50)).norm()), 15.05);
        }
  options.bounds = [](const Eigen::MatrixXd& points) -> Eigen::ArrayXd { return -Eigen::ArrayXd::Ones(points.cols()); };
  EXPECT_THROW(blend_morph(shapes, options), InputError);
}

TEST(BlendMorph, WhatCannotBeIsSaid) {
  const std::vector<KeyShape> shapes{disc("a", {35, 50}, 15), disc("b", {65, 50}, 15)};
  const auto refused = [&](const BlendMorphOptions& options, const std::string& about) {
    try {
      blend_morph(shapes, options);
      ADD_FAILURE() << about;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(about), std::string::npos) << error.what();
    }
  };
  BlendMorphOptions options;
  options.slab = {.from = 0, .to = 0.4};
  options.gap = TimeSpan{.from = 0.45, .to = 0.55};
  refused(options, "does not cover the gap");
  options.slab = {.from = 0.5, .to = 1.5};
  refused(options, "slab");
  KeyDeformation last{.key = 1, .from_mm = Eigen::Vector2d(0, 0), .to_mm = Eigen::Vector2d(1, 0)};
  options = {};
  options.deformations = {last};
  refused(options, "not on its way");
  std::vector<KeyShape> empty = shapes;
  std::get<ContourSlice>(empty[1].shape).contours.clear();
  EXPECT_THROW(blend_morph(empty, {}), InputError);
}

}  // namespace
}  // namespace isostack
