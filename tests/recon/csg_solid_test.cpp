#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recon/distance/distance_surface.h"
#include "recon/distance/solid.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"

namespace isostack {
namespace {

using Eigen::Vector3d;
using Kind = CsgSolid::Kind;

CsgSolid ball(const Vector3d& centre_mm, double radius_mm) {
  CsgSolid solid;
  solid.radii_mm.setConstant(radius_mm);
  solid.to_world.translation() = centre_mm;
  return solid;
}

CsgSolid combined(Kind kind, std::vector<CsgSolid> parts) {
  CsgSolid solid;
  solid.name = "test";
  solid.kind = kind;
  solid.parts = std::move(parts);
  return solid;
}

/// To two balls on the x axis, closed form: the surface is two spherical caps and the circle where they meet.
struct TwoBalls {
  double radius = 14, other_radius = 10, apart = 15;

  double circle_x() const { return (radius * radius - other_radius * other_radius + apart * apart) / (2 * apart); }
  double circle_radius() const { return std::sqrt(radius * radius - circle_x() * circle_x()); }

  /// Distance to the cap of the sphere about `centre` on one side of the circle (side: sign of x − circle_x).
  double to_cap(const Vector3d& p, double centre, double r, int side) const {
    const Vector3d out = p - Vector3d(centre, 0, 0);
    const Vector3d there = Vector3d(centre, 0, 0) + r * out.normalized();
    if (out.norm() > 1e-9 && side * (there.x() - circle_x()) >= 0) return std::abs(out.norm() - r);
    return std::hypot(p.x() - circle_x(), std::hypot(p.y(), p.z()) - circle_radius());
  }

  double distance(Kind kind, const Vector3d& p) const {
    const double first = radius - p.norm(), second = other_radius - (p - Vector3d(apart, 0, 0)).norm();
    const int outer = kind == Kind::intersection ? 1 : -1;
    const int inner = kind == Kind::set_union ? 1 : -1;
    const double mm = std::min(to_cap(p, 0, radius, outer), to_cap(p, apart, other_radius, inner));
    const bool inside = kind == Kind::set_union      ? first > 0 || second > 0
                        : kind == Kind::intersection ? first > 0 && second > 0
                                                     : first > 0 && second <= 0;
    return inside ? mm : -mm;
  }
};

TEST(CsgSolid, DistancesKeepTheirBoundAtThreeVoxelSizes) {
  const TwoBalls balls;
  for (const Kind kind : {Kind::set_union, Kind::intersection, Kind::difference}) {
    const CsgSolid solid =
        combined(kind, {ball({0, 0, 0}, balls.radius), ball({balls.apart, 0, 0}, balls.other_radius)});
    for (const double spacing_mm : {2.0, 4.0, 8.0}) {
      SolidDistanceOptions options;
      options.tolerance_mm = 0.05;
      options.keep_closest = true;
      const SolidDistance found = solid_distance(solid, distance_grid(solid, spacing_mm, 8), options);
      const Grid& grid = found.distance_mm.grid;
      double largest_mm = 0, largest_of_points_mm = 0;
      for (int k = 0; k < grid.size.z(); ++k)
        for (int j = 0; j < grid.size.y(); ++j)
          for (int i = 0; i < grid.size.x(); ++i) {
            const Vector3d p = grid.index_to_world * Vector3d(i, j, k);
            const double truth = balls.distance(kind, p);
            largest_mm = std::max(largest_mm, std::abs(found.distance_mm.at(i, j, k) - truth));
            const Vector3d& there = found.closest_points_mm[grid.offset(i, j, k)];
            largest_of_points_mm = std::max(largest_of_points_mm, std::abs(balls.distance(kind, there)));
          }
      EXPECT_LT(largest_mm, found.error_mm) << "operation " << static_cast<int>(kind) << ", " << spacing_mm << " mm";
      EXPECT_LT(largest_of_points_mm, found.error_mm);
    }
  }
}

TEST(CsgSolid, BandHoldsWhatIsNearAndTheBandBeyond) {
  const CsgSolid solid = combined(Kind::difference, {ball({0, 0, 0}, 14), ball({15, 0, 0}, 10)});
  const Grid grid = distance_grid(solid, 1.5, 4);
  const SolidDistance full = solid_distance(solid, grid, {.tolerance_mm = 0.05});
  const SolidDistance band =
      solid_distance(solid, grid, {.tolerance_mm = 0.05, .band_mm = 2.5, .extent = DistanceExtent::band});
  std::size_t near = 0;
  for (std::size_t i = 0; i < grid.voxel_count(); ++i) {
    const float mm = full.distance_mm.voxels[i];
    if (std::abs(mm) < 2.5f) {
      ++near;
      ASSERT_EQ(band.distance_mm.voxels[i], mm);
    } else {
      ASSERT_EQ(band.distance_mm.voxels[i], std::copysign(2.5f, mm));
    }
  }
  EXPECT_GT(near, 2000u);  // 5 mm round 2,300 mm², voxels of 3.4 mm³
}

TEST(CsgSolid, NearlySquareSuperellipsoidUnderAnAffineMap) {
  CsgSolid solid;
  solid.radii_mm = {10, 6, 8};
  solid.exponents = {0.1, 0.1};
  solid.to_world.linear() << 0, -2, 0, 1, 0, 0, 0.5, 0, 1;  // turned, stretched and sheared
  const double volume =
      measure(distance_surface(solid_distance(solid, distance_grid(solid, 0.75, 3)).distance_mm)).volume_mm3;
  // Barr's volume: 2 a1 a2 a3 e1 e2 B(e1/2 + 1, e1) B(e2/2, e2/2), times the map's determinant, 2.
  const double e = 0.1;
  const double truth = 2 * 2 * 480 * e * e * std::beta(e / 2 + 1, e) * std::beta(e / 2, e / 2);
  EXPECT_NEAR(volume, truth, 5e-3 * truth);  // edges are cut by up to a voxel: 0.1 mm² × 100 mm of edge
}

TEST(CsgSolid, ImplicitValueIsPositiveInside) {
  const CsgSolid solid = combined(Kind::difference, {ball({0, 0, 0}, 10), ball({10, 0, 0}, 4), ball({-10, 0, 0}, 4)});
  EXPECT_GT(implicit_value(solid, {0, 0, 0}), 0);
  EXPECT_LT(implicit_value(solid, {9, 0, 0}), 0);
  EXPECT_LT(implicit_value(solid, {-9, 0, 0}), 0);
  EXPECT_NEAR(implicit_value(solid, {0, 10, 0}), 0, 1e-12);
  EXPECT_LT(implicit_value(solid, {0, 11, 0}), 0);
}

TEST(CsgSolid, EmptySolidsAndBadNumbersAreRefused) {
  const auto problem_of = [](const CsgSolid& solid) -> std::string {
    try {
      solid_distance(solid, Grid{{8, 8, 8}, Eigen::Affine3d::Identity()});
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  const CsgSolid one = ball({0, 0, 0}, 5), far = ball({100, 0, 0}, 5), large = ball({0, 0, 0}, 9);
  EXPECT_NE(problem_of(combined(Kind::intersection, {one, far})).find("empty"), std::string::npos);
  EXPECT_NE(problem_of(combined(Kind::difference, {one, large})).find("empty"), std::string::npos);
  EXPECT_NE(problem_of(combined(Kind::set_union, {})).find("no parts"), std::string::npos);
  CsgSolid bad = one;
  bad.radii_mm.y() = 0;
  EXPECT_NE(problem_of(bad).find("radius"), std::string::npos);
  bad = one;
  bad.exponents.x() = 3;
  EXPECT_NE(problem_of(bad).find("exponent"), std::string::npos);
  bad = one;
  bad.to_world.linear().col(1).setZero();
  EXPECT_NE(problem_of(bad).find("flattens"), std::string::npos);
}

}  // namespace
}  // namespace isostack
