#include "recon/metrics/point_triangle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <random>

namespace isostack {
namespace {

const Triangle flat = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 0, 0), Eigen::Vector3d(0, 3, 0)};

TEST(ClosestPointOnTriangle, FaceEdgesAndCorners) {
  EXPECT_TRUE(closest_point_on_triangle(flat, {1, 1, 5}).isApprox(Eigen::Vector3d(1, 1, 0)));
  EXPECT_TRUE(closest_point_on_triangle(flat, {2, -3, 1}).isApprox(Eigen::Vector3d(2, 0, 0)));
  EXPECT_LT(closest_point_on_triangle(flat, {-1, -2, 3}).norm(), 1e-15);
  EXPECT_TRUE(closest_point_on_triangle(flat, {9, -1, 0}).isApprox(Eigen::Vector3d(4, 0, 0)));
  EXPECT_TRUE(closest_point_on_triangle(flat, {-1, 9, 2}).isApprox(Eigen::Vector3d(0, 3, 0)));
  // Off the middle of the hypotenuse along its normal (3, 4)/5.
  EXPECT_TRUE(closest_point_on_triangle(flat, {2 + 3, 1.5 + 4, 7}).isApprox(Eigen::Vector3d(2, 1.5, 0)));
}

TEST(ClosestPointOnTriangle, NoPointOfTheTriangleIsNearer) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-5, 5), weight(0, 1);
  const auto any = [&] { return Eigen::Vector3d(uniform(random), uniform(random), uniform(random)); };
  for (int trial = 0; trial < 300; ++trial) {
    const Triangle t = {any(), any(), any()};
    const Eigen::Vector3d p = any(), closest = closest_point_on_triangle(t, p);
    const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    EXPECT_NEAR(normal.dot(closest - t[0]), 0, 1e-12);
    for (int i = 0; i < 200; ++i) {
      double u = weight(random), v = weight(random);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Eigen::Vector3d other = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      // Convexity: the way to any other point leads away from p.
      ASSERT_LE((p - closest).dot(other - closest), 1e-11);
    }
  }
}

TEST(ClosestPointOnTriangle, DegenerateTrianglesAreSegmentsOrPoints) {
  const Eigen::Vector3d a(1, 1, 1), b(3, 1, 1), p(2, 4, 1);
  EXPECT_TRUE(closest_point_on_triangle({a, b, Eigen::Vector3d(5, 1, 1)}, p).isApprox(Eigen::Vector3d(2, 1, 1)));
  EXPECT_TRUE(closest_point_on_triangle({a, b, a}, p).isApprox(Eigen::Vector3d(2, 1, 1)));
  EXPECT_TRUE(closest_point_on_triangle({a, a, a}, p).isApprox(a));
}

TEST(ClosestPointOnTriangle, SliversAreAsGoodAsSegments) {
  for (double width = 1e-12; width < 1e-3; width *= 2) {
    const Triangle sliver = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(2, width, 0)};
    for (const double x : {0.1, 0.3, 0.7, 1.3, 1.9}) {
      const Eigen::Vector3d p(x, 0, 0.01);
      // The sliver is nowhere wider than `width`.
      EXPECT_NEAR((closest_point_on_triangle(sliver, p) - p).norm(), 0.01, width + 1e-6) << width << " at " << x;
    }
  }
}

}  // namespace
}  // namespace isostack
