// Cutting a reconstruction with the planes it was made from gives the contours back.
#include "recon/metrics/input_sections.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recon/geometry/pixel_lattice.h"
#include "recon/metrics/surface_distance.h"
#include "recon/reconstruct.h"
#include "recon/surface/plane_section.h"
#include "segmentation/trace_contours.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/analytic_shapes.h"
#include "tests/support/crossing_slices.h"

namespace isostack {
namespace {

using testing_support::circle;
using testing_support::orthogonal_slices;
using testing_support::sphere_cuts;
using testing_support::sphere_mesh;

/// What `--interpolate` sets.
ReconstructOptions interpolating() {
  ReconstructOptions options;
  options.softening.strength = 0;
  options.sample_spacing_pixels = 0.2;
  options.section_tolerance_pixels = 0.1;
  options.section_rounds = 6;
  return options;
}

ContourSlice slice_at(double z_mm, std::vector<Contour> contours) {
  ContourSlice slice{.name = "z = " + std::to_string(z_mm), .pose = {}, .contours = std::move(contours)};
  slice.pose.origin_mm.z() = z_mm;
  return slice;
}

/// A tube 2.5 pixels thick that runs obliquely, moving by its own width from slice to slice.
ContourStack thin_tube() {
  ContourStack tube{.name = "tube", .slices = {}};
  for (int i = 0; i < 8; ++i) tube.slices.push_back(slice_at(2 * i, {circle({2.0 * i, 0.3 * i}, 1.25, 40)}));
  return tube;
}

/// A palm that splits into two fingers, 1.5 pixels apart at first.
ContourStack two_fingers() {
  ContourStack hand{.name = "fingers", .slices = {}};
  for (int i = 0; i < 3; ++i) hand.slices.push_back(slice_at(3 * i, {circle({0, 0}, 9, 120)}));
  for (int i = 0; i < 5; ++i) {
    const double away_mm = 4.75 + 0.5 * i;
    hand.slices.push_back(slice_at(9 + 3 * i, {circle({-away_mm, 0}, 4, 60), circle({away_mm, 0}, 4, 60)}));
  }
  hand.slices.push_back(slice_at(24, {}));
  return hand;
}

/// An ellipsoid with half axes 20, 14, 24 mm as labels, pixels of 1 mm: contours with stairs of half pixels.
ContourStack label_ellipsoid() {
  ContourStack stack{.name = "labels", .slices = {}};
  for (double z = -22; z <= 22; z += 4) {
    ContourSlice slice = slice_at(z, {});
    slice.size_pixels = {60, 60};
    slice.pose.origin_mm.head<2>() = Eigen::Vector2d(-29.7, -30.2);
    Image<float> label(60, 60);
    for (int row = 0; row < 60; ++row)
      for (int column = 0; column < 60; ++column) {
        const Eigen::Vector3d q = slice.pose.slice_to_world({column, row}).cwiseQuotient(Eigen::Vector3d(20, 14, 24));
        label(row, column) = q.norm() <= 1 ? 0.5F : -0.5F;
      }
    slice.contours = trace_contours(label, slice.pose.spacing_mm);
    stack.slices.push_back(slice);
  }
  return stack;
}

struct Case {
  const char* name;
  ContourStack (*stack)();
  double pixel_mm;
};

ContourStack parallel_sphere() { return sphere_cuts(20, {}, {-25, -15, -7, 0, 7, 15}, 160); }
ContourStack crossing() { return orthogonal_slices(); }

class InputSections : public testing::TestWithParam<Case> {
 protected:
  void expect_within(double pixels, const ReconstructOptions& options) const {
    const Reconstruction r = reconstruct(GetParam().stack(), options);
    const SliceAgreement& sections = r.report.sections;
    EXPECT_TRUE(sections.has_distances);
    EXPECT_EQ(sections.slices, GetParam().stack().slices.size());
    EXPECT_EQ(sections.one_sided, 0u);  // no section where the organ is absent, and one wherever it is not
    EXPECT_LE(sections.largest_mm, pixels * GetParam().pixel_mm);
    expect_same_side(r.surface, pixels);
    EXPECT_EQ(r.report.plane_points_wrong, 0u);
  }

  /// Every pixel centre is inside the section where it is inside the contours, unless it lies on them.
  static void expect_same_side(const TriangleMesh& surface, double tolerance_pixels) {
    const ContourStack stack = GetParam().stack();
    for (const ContourSlice& slice : stack.slices) {
      const std::vector<Contour> section = plane_section(surface, slice.pose);
      const PixelLattice lattice = lattice_of(slice, stack);
      for (int row = 0; row < lattice.size_pixels.y(); ++row)
        for (int column = 0; column < lattice.size_pixels.x(); ++column) {
          const Eigen::Vector2d in_lattice = lattice.pose.spacing_mm.cwiseProduct(Eigen::Vector2d(column, row));
          const Eigen::Vector2d p = slice.pose.world_to_slice(lattice.pose.slice_to_world(in_lattice));
          if (is_inside(section, p) == is_inside(slice.contours, p)) continue;
          EXPECT_LE(std::abs(signed_distance_mm(slice.contours, p)), tolerance_pixels * GetParam().pixel_mm)
              << slice.name << " at " << p.transpose();
        }
    }
  }
};

TEST_P(InputSections, InterpolatedWithinATenthOfAPixel) { expect_within(0.1, interpolating()); }

TEST_P(InputSections, ByDefaultWithinAQuarterOfAPixel) { expect_within(0.25, {}); }

INSTANTIATE_TEST_SUITE_P(Shapes, InputSections,
                         testing::Values(Case{"sphere", parallel_sphere, 1}, Case{"tube", thin_tube, 1},
                                         Case{"fingers", two_fingers, 1}, Case{"labels", label_ellipsoid, 1},
                                         Case{"crossing", crossing, 0.8}),
                         [](const auto& shape) { return shape.param.name; });

TEST(AgreementAtInputs, ContoursThatNoSectionComesNearAreMissed) {
  ContourStack cuts = sphere_cuts(20, {}, {0, 12, 24}, 400);
  cuts.slices[0].contours.push_back(circle({21, 0}, 0.6, 8));  // 0.4 mm beside the section
  cuts.slices[1].contours.push_back(circle({25, 0}, 0.6, 8));  // 8.4 mm
  cuts.slices[2].contours.push_back(circle({0, 0}, 0.6, 8));   // where there is no section
  EXPECT_EQ(agreement_at_inputs(sphere_mesh(Eigen::Vector3d::Zero(), 20, 400, 200), cuts).missed, 2u);
}

TEST(AgreementAtInputs, AreMeasuredBothWays) {
  // A sphere of radius 20 mm against a stack of contours 2 mm too small, and one slice that knows nothing of it.
  ContourStack cuts = sphere_cuts(20, {}, {0, 12}, 400);
  cuts.slices[0].contours = {circle({0, 0}, 18, 400)};
  cuts.slices[1].contours.clear();
  const SliceAgreement found = agreement_at_inputs(sphere_mesh(Eigen::Vector3d::Zero(), 20, 400, 200), cuts);
  EXPECT_EQ(found.slices, 2u);
  EXPECT_EQ(found.one_sided, 1u);
  EXPECT_NEAR(found.mean_mm, 2, 0.01);  // facets and chords
  EXPECT_NEAR(found.largest_mm, 2, 0.02);
  // Areas 18², against 20² and 16² on the slices: 2 · 324 / (400 + 256 + 324), in pixels of 1 mm.
  EXPECT_NEAR(found.dice, 2.0 * 324 / (400 + 256 + 324), 0.01);
}

TEST(ObliqueCuts, StairsOfLabelsDoNotGrowFromSolveToSolve) {
  ReconstructOptions options;
  options.section_rounds = 0;
  const Reconstruction five = reconstruct(label_ellipsoid(), options);
  options.solves = 10;
  const Reconstruction ten = reconstruct(label_ellipsoid(), options);
  EXPECT_GT(ten.report.solves, five.report.solves);
  // Where the corrections have settled, five more change less than what the sections are held to.
  const SurfaceDistance moved = surface_distance(five.surface, ten.surface, {.samples = 5000});
  EXPECT_LT(moved.largest_mm, 0.25);
  EXPECT_LT(moved.mean_mm, 0.02);
}

}  // namespace
}  // namespace isostack
