#include "segmentation/fast_marching.h"

#include <gtest/gtest.h>

#include "segmentation/derivatives.h"
#include "tests/segmentation/fields.h"

namespace isostack {
namespace {

using test::field_from;

TEST(Redistance, DiscOnAnisotropicSpacingBecomesItsDistance) {
  const Eigen::Vector2d centre(20.3, 19.6);
  // Neither a distance nor odd across the edge: the square of the radius, scaled.
  auto phi =
      field_from<2>({81, 58}, {0.5, 0.7}, [&](const auto& p) { return 40 * (100 - (p - centre).squaredNorm()); });
  redistance(phi, 8);
  double worst_mm = 0;
  for (std::size_t node = 0; node < phi.values.size(); ++node) {
    const auto position = phi.position_of(node);
    const double r = (Eigen::Vector2d(position[0] * 0.5, position[1] * 0.7) - centre).norm();
    const double exact = std::clamp(10 - r, -8.0, 8.0);
    if (r > 4) worst_mm = std::max(worst_mm, std::abs(phi.values[node] - exact));
  }
  EXPECT_LT(worst_mm, 0.03);  // a few per cent of a pixel, the second-order error of the innermost nodes
}

TEST(Redistance, EllipseHasUnitGradientWhereTheClosestPointIsUnique) {
  const double a = 15, b = 9;  // its medial axis: |x| <= (a² − b²)/a on the long axis
  const Eigen::Vector2d centre(20, 16);
  auto phi = field_from<2>({67, 54}, {0.6, 0.6}, [&](const auto& p) {
    const Eigen::Vector2d q = p - centre;
    return 1 - q.x() * q.x() / (a * a) - q.y() * q.y() / (b * b);
  });
  redistance(phi, 4.5);
  int checked = 0;
  for (std::size_t node = 0; node < phi.values.size(); ++node) {
    if (std::abs(phi.values[node]) > 3.3) continue;
    const auto position = phi.position_of(node);
    const Eigen::Vector2d q = (Eigen::Vector2d(position[0], position[1]) * 0.6 - centre).cwiseAbs();
    // The central difference must not reach over the medial axis.
    if (q.y() < 1.3 && q.x() < (a * a - b * b) / a + 1.3) continue;
    EXPECT_NEAR(derivatives_at(phi, node).gradient().norm(), 1, 0.05) << q.transpose();
    ++checked;
  }
  EXPECT_GT(checked, 500);
}

TEST(Redistance, ObliqueLineIsExact) {
  const Eigen::Vector2d normal = Eigen::Vector2d(3, 4) / 5;
  auto phi = field_from<2>({30, 30}, {1, 0.8}, [&](const auto& p) { return -7 * (p.dot(normal) - 15.3); });
  redistance(phi, 6);
  for (std::size_t node = 0; node < phi.values.size(); ++node) {
    const auto at = phi.position_of(node);
    const double exact = 15.3 - Eigen::Vector2d(at[0], at[1] * 0.8).dot(normal);
    // At the border some nodes have no upwind neighbour to see the line through: compare inside.
    if (std::abs(exact) < 5 && at[0] > 6 && at[0] < 23 && at[1] > 6 && at[1] < 23) {
      EXPECT_NEAR(phi.values[node], exact, 1e-4);  // float values
    }
  }
}

TEST(Redistance, StepKeepsItsCrossings) {
  // A sharp edge with one partial pixel: crossings of the linear interpolation stay where they are.
  auto phi = field_from<2>({20, 5}, {1, 1}, [](const auto& p) { return p.x() < 10 ? 1 : p.x() == 10 ? 0.25 : -1; });
  redistance(phi, 4);
  const double inner = phi.values[phi.node_at({10, 2})], outer = phi.values[phi.node_at({11, 2})];
  EXPECT_NEAR(inner, 0.2, 1e-6);  // 0.25 / (0.25 + 1)
  EXPECT_NEAR(outer, -0.8, 1e-6);
}

TEST(Redistance, BallInThreeDimensions) {
  const Eigen::Vector3d centre(12, 12.4, 11.7);
  auto phi = field_from<3>({25, 25, 13}, {1, 1, 2}, [&](const auto& p) { return 64 - (p - centre).squaredNorm(); });
  redistance(phi, 3);
  for (std::size_t node = 0; node < phi.values.size(); ++node) {
    const auto at = phi.position_of(node);
    const double exact = 8 - (Eigen::Vector3d(at[0], at[1], at[2] * 2) - centre).norm();
    if (std::abs(exact) < 2.9) {
      EXPECT_NEAR(phi.values[node], exact, 0.1);  // 5 % of the coarse spacing
    }
  }
}

TEST(Redistance, WithoutZeroSetEverythingIsTheBand) {
  auto phi = field_from<2>({4, 3}, {1, 1}, [](const auto&) { return -0.3; });
  redistance(phi, 5);
  for (float value : phi.values) EXPECT_EQ(value, -5);
}

TEST(Redistance, ExactZerosCountAsInside) {
  auto phi = field_from<2>({9, 9}, {1, 1}, [](const auto& p) { return 4 - p.x(); });
  redistance(phi, 3);
  EXPECT_EQ(phi.values[phi.node_at({4, 4})], 0);
  EXPECT_FALSE(std::signbit(phi.values[phi.node_at({4, 4})]));
  EXPECT_NEAR(phi.values[phi.node_at({5, 4})], -1, 1e-6);
  EXPECT_NEAR(phi.values[phi.node_at({2, 4})], 2, 1e-6);
}

}  // namespace
}  // namespace isostack
