#include "segmentation/speed_terms.h"

#include <gtest/gtest.h>

#include "tests/segmentation/fields.h"

namespace isostack {
namespace {

using test::field_from;

TEST(IsosurfaceTerm, IsGOfTheDistanceInPixelsOnARamp) {
  // I = 5x + 10 in steps of 2 mm, level 40: the edge is at x = 6 mm, α = (x − 6)/w.
  const auto ramp = field_from<2>({9, 4}, {2, 2}, [](const auto& p) { return 5 * p.x() + 10; });
  const IsosurfaceTerm<2> term(ramp, 40, 2);
  for (int column = 0; column < 9; ++column) {
    const double alpha = (2.0 * column - 6) / 2;
    EXPECT_NEAR(term.propagation(ramp.node_at({column, 1})), alpha / std::sqrt(1 + alpha * alpha), 1e-12);
  }
}

TEST(IsosurfaceTerm, ExpandsInFlatBrightAndShrinksInFlatDarkRegions) {
  const auto step = field_from<2>({20, 5}, {1, 1}, [](const auto& p) { return p.x() < 10 ? 100 : 0; });
  const IsosurfaceTerm<2> term(step, 50, 1);
  EXPECT_GT(term.propagation(step.node_at({2, 2})), 0.99);
  EXPECT_LT(term.propagation(step.node_at({17, 2})), -0.99);
  const auto flat = field_from<2>({3, 3}, {1, 1}, [](const auto&) { return 7; });
  EXPECT_EQ(IsosurfaceTerm<2>(flat, 7, 1).propagation(4), 0);
  EXPECT_EQ(IsosurfaceTerm<2>(flat, 5, 1).propagation(4), 1);
}

TEST(IsosurfaceTerm, UnitsOfTheImageDoNotMatter) {
  const auto bump = field_from<2>({9, 9}, {1, 1}, [](const auto& p) { return std::exp(-p.squaredNorm() / 20); });
  auto scaled = bump;
  for (float& value : scaled.values) value = 1000 * value - 300;
  const IsosurfaceTerm<2> a(bump, 0.4, 1), b(scaled, 100, 1);
  for (std::size_t node = 0; node < bump.values.size(); ++node)
    EXPECT_NEAR(a.propagation(node), b.propagation(node), 1e-4);  // float pixels
}

}  // namespace
}  // namespace isostack
