#include "segmentation/derivatives.h"

#include <gtest/gtest.h>

#include "tests/segmentation/fields.h"

namespace isostack {
namespace {

using test::field_from;

TEST(Derivatives, QuadraticIsExactAlsoOnAnisotropicSpacing) {
  const auto field = field_from<2>({7, 6}, {0.5, 2}, [](const auto& p) {
    return 3 * p.x() * p.x() - 2 * p.x() * p.y() + 0.5 * p.y() * p.y() + p.x();
  });
  const auto d = derivatives_at(field, field.node_at({3, 2}));  // at (1.5, 4) mm
  EXPECT_NEAR(d.gradient().x(), 6 * 1.5 - 2 * 4 + 1, 1e-4);     // float values
  EXPECT_NEAR(d.gradient().y(), -2 * 1.5 + 4, 1e-4);
  EXPECT_NEAR(d.hessian(0, 0), 6, 1e-4);
  EXPECT_NEAR(d.hessian(1, 1), 1, 1e-4);
  EXPECT_NEAR(d.hessian(0, 1), -2, 1e-4);
}

TEST(Derivatives, LinearFieldContinuesBeyondEveryBorder) {
  const auto field = field_from<3>({3, 4, 1}, {1, 2, 3}, [](const auto& p) { return 2 * p.x() - p.y(); });
  for (std::size_t node = 0; node < field.values.size(); ++node) {
    const auto d = derivatives_at(field, node);
    EXPECT_NEAR((d.gradient() - Eigen::Vector3d(2, -1, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR(d.hessian.norm(), 0, 1e-12);
  }
}

TEST(Derivatives, CurvatureOfDiscAndBallIsNegativeInverseRadius) {
  const auto disc =
      field_from<2>({41, 41}, {1, 1}, [](const auto& p) { return 12 - (p - Eigen::Vector2d(20, 20)).norm(); });
  EXPECT_NEAR(derivatives_at(disc, disc.node_at({32, 20})).mean_curvature(), -1.0 / 12, 2e-4);  // O(h²/r³)
  const auto ball = field_from<3>({31, 31, 31}, {1, 1, 1},
                                  [](const auto& p) { return 10 - (p - Eigen::Vector3d(15, 15, 15)).norm(); });
  EXPECT_NEAR(derivatives_at(ball, ball.node_at({15, 25, 15})).mean_curvature(), -2.0 / 10, 1e-3);
}

TEST(Derivatives, UpwindTakesTheSideInformationComesFrom) {
  // A ridge at the node: an expanding front sees nothing higher, a shrinking one both flanks (the steeper counts).
  Field<2> field{{3, 1}, {1, 1}, {-2, 0, -1}};
  const auto ridge = derivatives_at(field, 1);
  EXPECT_EQ(ridge.upwind_gradient_norm(true), 0);
  EXPECT_EQ(ridge.upwind_gradient_norm(false), 2);
  field.values = {2, 0, 1};
  const auto valley = derivatives_at(field, 1);
  EXPECT_EQ(valley.upwind_gradient_norm(true), 2);
  EXPECT_EQ(valley.upwind_gradient_norm(false), 0);
}

}  // namespace
}  // namespace isostack
