#include "recon/constraints/mesh_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "recon/geometry/errors.h"
#include "recon/metrics/surface_distance.h"
#include "tests/support/morph_meshes.h"

namespace isostack {
namespace {

using testing_support::inside_out;
using testing_support::sphere_mesh;
using testing_support::together;

constexpr double radius_mm = 40;

TriangleMesh sphere() { return sphere_mesh(Eigen::Vector3d(5, -3, 9), radius_mm, 128, 64); }

double nearest_mm(const std::vector<MeshSample>& samples, const Eigen::Vector3d& point, const MeshSample* but) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const MeshSample& sample : samples)
    if (&sample != but) nearest = std::min(nearest, (sample.point_mm - point).norm());
  return nearest;
}

TEST(MeshSamples, SamplesAreSpreadEvenlyUpToTheirNumber) {
  const TriangleMesh mesh = sphere();
  const std::vector<MeshSample> samples = spread_samples(mesh, {.max_samples = 500});
  EXPECT_LE(samples.size(), 500U);
  EXPECT_GE(samples.size(), 475U);
  double smallest_gap = std::numeric_limits<double>::infinity(), largest_hole = 0;
  for (const MeshSample& sample : samples)
    smallest_gap = std::min(smallest_gap, nearest_mm(samples, sample.point_mm, &sample));
  for (const Eigen::Vector3d& point : sample_surface(mesh, 2000, 7))
    largest_hole = std::max(largest_hole, nearest_mm(samples, point, nullptr));
  // 500 points placed at random have neighbours at a hundredth of the even spacing, sqrt(area / 500) = 6.3 mm.
  EXPECT_GT(smallest_gap, 0.7 * 6.3);
  EXPECT_LT(largest_hole, 1.2 * smallest_gap);  // discs of that radius fill the surface, up to the pool's gaps
}

TEST(MeshSamples, SamplesKeepTheWantedSpacing) {
  const TriangleMesh mesh = sphere();
  const std::vector<MeshSample> samples = spread_samples(mesh, {.max_samples = 100'000, .min_spacing_mm = 8});
  for (const MeshSample& sample : samples) EXPECT_GE(nearest_mm(samples, sample.point_mm, &sample), 8);
  // Discs of radius 4 mm on 20,106 mm2, at the 55 % of the area that thinning at random reaches, up to 20 % off.
  EXPECT_NEAR(static_cast<double>(samples.size()), 0.55 * 20106 / (std::numbers::pi * 16), 0.2 * 220);
}

TEST(MeshSamples, SamplesLieOnTheSurfaceWithItsNormals) {
  const TriangleMesh mesh = sphere();
  for (const std::vector<MeshSample>& samples : {spread_samples(mesh, {.max_samples = 300}), vertex_samples(mesh)})
    for (const MeshSample& sample : samples) {
      const Eigen::Vector3d out = sample.point_mm - Eigen::Vector3d(5, -3, 9);
      EXPECT_NEAR(out.norm(), radius_mm, 0.05);                // chords of 128 meridians
      EXPECT_GT(sample.outward.dot(out.normalized()), 0.999);  // half a triangle of 2.8 degrees
      EXPECT_NEAR(sample.outward.norm(), 1, 1e-12);
    }
}

TEST(MeshSamples, TheSeedAloneDecides) {
  const TriangleMesh mesh = sphere();
  const auto first = spread_samples(mesh, {.max_samples = 100}), again = spread_samples(mesh, {.max_samples = 100});
  const auto other = spread_samples(mesh, {.max_samples = 100, .seed = 2});
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].point_mm, again[i].point_mm);
  EXPECT_NE(first.front().point_mm, other.front().point_mm);
}

std::string refusal(const TriangleMesh& mesh) {
  try {
    spread_samples(mesh, {.max_samples = 10});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MeshSamples, WhatIsNotClosedIsRefusedByName) {
  TriangleMesh open = sphere();
  open.name = "left ventricle";
  open.triangles.pop_back();
  EXPECT_NE(refusal(open).find("left ventricle"), std::string::npos);
  EXPECT_NE(refusal(open).find("3 edges"), std::string::npos);
  EXPECT_NE(refusal(inside_out(sphere())).find("inwards"), std::string::npos);
  EXPECT_NE(refusal({}).find("no triangles"), std::string::npos);
  TriangleMesh broken = sphere();
  broken.vertices_mm[3].x() = std::nan("");
  EXPECT_NE(refusal(broken).find("not finite"), std::string::npos);
  EXPECT_THROW(vertex_samples(open), InputError);
}

// The small ball has 1/1600 of the area: one sample of 1000 would not make a ball of it.
TEST(MeshSamples, SmallPartsAreNotLost) {
  const TriangleMesh mesh = together(sphere(), sphere_mesh(Eigen::Vector3d(100, 0, 0), 1, 32, 16));
  const std::vector<MeshSample> samples = spread_samples(mesh, {.max_samples = 1000});
  EXPECT_LE(samples.size(), 1000U);
  EXPECT_GE(samples.size(), 900U);
  const auto in_small =
      std::count_if(samples.begin(), samples.end(), [](const MeshSample& sample) { return sample.point_mm.x() > 90; });
  EXPECT_GE(in_small, 8);
  EXPECT_LE(in_small, 12);
}

}  // namespace
}  // namespace isostack
