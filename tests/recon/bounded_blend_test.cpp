#include "recon/functions/bounded_blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recon/functions/point_deformation.h"
#include "recon/functions/r_functions.h"
#include "recon/functions/solids.h"
#include "recon/functions/space_time.h"
#include "recon/geometry/errors.h"
#include "tests/support/morph_meshes.h"

namespace isostack {
namespace {

constexpr double rounding = 1e-12;

double value(const SolidFunction& solid, const Eigen::VectorXd& point) { return solid(Eigen::MatrixXd(point))[0]; }

SolidFunction ball(const Eigen::VectorXd& centre_mm, double radius_mm) {
  return [=](const Eigen::MatrixXd& points) -> Eigen::ArrayXd {
    return radius_mm - (points.colwise() - centre_mm).colwise().norm().transpose().array();
  };
}

TEST(RFunctions, HaveTheSignOfTheSetOperation) {
  for (const double a : {-2.0, -0.1, 0.3, 5.0})
    for (const double b : {-3.0, -0.2, 0.1, 4.0}) {
      const Eigen::ArrayXd f1 = Eigen::ArrayXd::Constant(1, a), f2 = Eigen::ArrayXd::Constant(1, b);
      EXPECT_EQ(r_union(f1, f2)[0] > 0, a > 0 || b > 0);
      EXPECT_EQ(r_intersection(f1, f2)[0] > 0, a > 0 && b > 0);
      EXPECT_EQ(r_subtraction(f1, f2)[0] > 0, a > 0 && b < 0);
    }
}

TEST(BoundedBlend, DisplacementIsThatOfThePaper) {
  const auto disp = [](double f1, double f2, double f3) {
    const auto one = [](double f) { return Eigen::ArrayXd::Constant(1, f); };
    return blend_displacement(one(f1), one(f2), one(f3), {.a0 = 9, .a1 = 2, .a2 = 4, .a3 = 3})[0];
  };
  EXPECT_EQ(disp(0, 0, 1), 1);  // r = 0
  EXPECT_EQ(disp(0, 0, 0), 0);  // the bounds' own boundary counts as outside
  EXPECT_EQ(disp(1, 1, -1), 0);
  // r1² = 1/4 + 1/4, r2² = 1/2: r² = 1/2, (1/2)³ / (3/2).
  EXPECT_NEAR(disp(1, 2, 3 / std::sqrt(2.0)), 1 / 12.0, rounding);
  EXPECT_THROW(bounded_blend_union({}, {}, {}, {.a0 = 1, .a1 = 0}), InputError);
  EXPECT_THROW(bounded_blend_subtraction({}, {}, {}, {.a0 = -1}), InputError);
}

TEST(BoundedBlend, AddsAndTakesAwayWithinTheBoundsOnly) {
  const Eigen::Vector2d left(-1.2, 0), right(1.2, 0), between(0, 0), far(0, 3);
  const SolidFunction one = ball(left, 1), other = ball(right, 1), bounds = ball(between, 1.5);
  const BlendParameters strong{.a0 = 1};
  const SolidFunction joined = bounded_blend_union(one, other, bounds, strong), plain = r_union(one, other);
  EXPECT_LT(value(plain, between), 0);
  EXPECT_GT(value(joined, between), 0);
  EXPECT_EQ(value(joined, far), value(plain, far));
  const SolidFunction less = bounded_blend_subtraction(one, other, bounds, strong), cut = r_subtraction(one, other);
  const Eigen::Vector2d edge(-0.25, 0);  // in the first disc, near the second
  EXPECT_GT(value(cut, edge), 0);
  EXPECT_LT(value(less, edge), value(cut, edge));
  EXPECT_EQ(value(less, far), value(cut, far));
}

TEST(SpaceTime, HalfCylindersEndAtTheGapAndSectionsOutsideTheSlabAreTheShapes) {
  const SolidFunction first = ball(Eigen::Vector2d(0, 0), 1), second = ball(Eigen::Vector2d(5, 0), 2);
  const HalfCylinderSmoothing smoothing{.blend = {.a0 = 0.8}, .reach_mm = 10};
  const SpaceTimeBlend blend{.gap_mm = {0, 1},
                             .slab_mm = {-10, 11},
                             .blend = {.a0 = 8, .a1 = 2, .a2 = 2},
                             .first = smoothing,
                             .second = smoothing};
  const SolidFunction f = space_time_blend(cylinder(first), cylinder(second), blend);
  for (double angle = 0; angle < 6; angle += 0.37) {
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
    for (const double near : {-1e-6, 1e-6})  // the sign turns within a millionth of a millimetre
      for (const double beyond : {0.0, 0.5, 30.0}) {
        const SolidFunction before = cross_section(f, -10 - beyond), after = cross_section(f, 11 + beyond);
        EXPECT_EQ(value(before, (1 - near) * out) > 0, near > 0);
        EXPECT_EQ(value(after, Eigen::Vector2d(5, 0) + (2 - near) * out) > 0, near > 0);
      }
  }
  EXPECT_GT(value(cross_section(f, 0.5), Eigen::Vector2d(2, 0)), 0);  // in neither shape
}

TEST(SpaceTime, SlabsThatDoNotCoverTheGapAreRefused) {
  const SolidFunction disc = cylinder(ball(Eigen::Vector2d(0, 0), 1));
  const auto refused = [&](const SpaceTimeBlend& blend) {
    EXPECT_THROW(space_time_blend(disc, disc, blend), InputError);
  };
  refused({.gap_mm = {0, 1}, .slab_mm = {0.5, 2}, .blend = {}, .first = {}, .second = {}});
  refused({.gap_mm = {0, 1}, .slab_mm = {-1, 0.5}, .blend = {}, .first = {}, .second = {}});
  refused({.gap_mm = {1, 0}, .slab_mm = {-1, 2}, .blend = {}, .first = {}, .second = {}});
  refused({.gap_mm = {0, 1},
           .slab_mm = {-1, 2},
           .blend = {},
           .first = HalfCylinderSmoothing{.blend = {}, .reach_mm = 3},
           .second = {}});
}

TEST(Solids, MeshesAndFiguresAreTheirSignedDistances) {
  const Eigen::Vector3d low(-1, -2, -3), high(1, 2, 3);
  const SolidFunction box = mesh_solid(testing_support::box_mesh(low, high));
  Eigen::MatrixXd points = 5 * Eigen::MatrixXd::Random(3, 500);  // Eigen's generator starts alike each time
  points.col(0) = Eigen::Vector3d(2, 3, 4);                      // nearest to a corner,
  points.col(1) = Eigen::Vector3d(2, 3, 0);                      // an edge
  const Eigen::ArrayXd mm = box(points);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d p = points.col(i);
    const Eigen::Vector3d off = p.cwiseAbs() - high;
    EXPECT_NEAR(mm[i], -off.cwiseMax(0).norm() - std::min(off.maxCoeff(), 0.0), rounding);
  }
  const Contour square{.points_mm = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  const SolidFunction figure = figure_solid({square});
  EXPECT_NEAR(value(figure, Eigen::Vector2d(1, 2)), 1, rounding);
  EXPECT_NEAR(value(figure, Eigen::Vector2d(7, 8)), -5, rounding);
  EXPECT_THROW(figure_solid({}), InputError);
  EXPECT_THROW(mesh_solid({}), InputError);
}

TEST(Solids, VolumesAreLinearBetweenNodesAndGoOnOutside) {
  Grid grid;
  grid.size = {3, 4, 5};
  grid.index_to_world.linear() *= 2;
  Volume<float> ramp(grid);
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 3; ++i) ramp.at(i, j, k) = static_cast<float>(2 * i + 4 * j - 2 * k);
  const SolidFunction volume = volume_solid(ramp);
  EXPECT_NEAR(value(volume, Eigen::Vector3d(1.3, 4.4, 2.6)), 1.3 + 8.8 - 2.6, 1e-5);  // floats
  EXPECT_NEAR(value(volume, Eigen::Vector3d(-3, 0, 0)), -3, 1e-5);
}

TEST(Solids, SuperellipsoidsGoFromBallToBox) {
  const SolidFunction round = superellipsoid_solid({.half_axes_mm = {2, 2, 2}});
  EXPECT_NEAR(value(round, Eigen::Vector3d(1, 0.5, 0.2)), 2 - Eigen::Vector3d(1, 0.5, 0.2).norm(), rounding);
  Superellipsoid box{.half_axes_mm = {1, 2, 3}, .south_north = 0.05, .east_west = 0.05};
  box.to_world.translate(Eigen::Vector3d(10, 0, 0));
  EXPECT_GT(value(superellipsoid_solid(box), Eigen::Vector3d(10.95, 1.9, 2.85)), 0);
  EXPECT_LT(value(superellipsoid_solid(box), Eigen::Vector3d(11.01, 0, 0)), 0);
  EXPECT_THROW(superellipsoid_solid({.half_axes_mm = {1, 0, 1}}), InputError);
}

TEST(PointDeformation, MovesThePointOnTimeAndLeavesWhatIsFar) {
  const SolidFunction disc = cylinder(ball(Eigen::Vector2d(0, 0), 1));
  const PointDeformation pull{
      .from_mm = Eigen::Vector2d(1, 0), .to_mm = Eigen::Vector2d(2, 0), .radius_mm = 1.6, .during_mm = {2, 4}};
  const SolidFunction f = deformed(disc, pull);
  EXPECT_NEAR(value(f, Eigen::Vector3d(1, 0, 2)), 0, rounding);
  EXPECT_NEAR(value(f, Eigen::Vector3d(1.5, 0, 3)), 0, rounding);  // half way at half time
  EXPECT_NEAR(value(f, Eigen::Vector3d(2, 0, 9)), 0, rounding);
  EXPECT_NEAR(value(f, Eigen::Vector3d(-1, 0, 9)), 0, rounding);
  PointDeformation folding = pull;
  folding.radius_mm = 1.5;
  EXPECT_THROW(deformed(disc, folding), InputError);
}

}  // namespace
}  // namespace isostack
