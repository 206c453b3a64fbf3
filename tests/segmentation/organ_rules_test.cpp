#include "segmentation/organ_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

TEST(OrganRules, StepsComeInTheirFixedOrder) {
  OrganRules rules;
  rules.gaussian_sigma_pixels = 0.5;
  rules.level = 150;
  rules.seeds = {Seed{{1, 2, 3}, "liver"}};
  rules.start = {GrowStep{1}};
  rules.open_mm = 2;
  rules.close_mm = 3;
  rules.hull = rules.fill_holes = rules.largest = true;
  const OrganOptions options = organ_options(rules);
  ASSERT_EQ(options.start.size(), 9u);
  EXPECT_TRUE(std::holds_alternative<GaussianStep>(options.start[0]));
  EXPECT_EQ(std::get<RangeStep>(options.start[1]).range.low, 150);
  EXPECT_TRUE(std::holds_alternative<GrowStep>(options.start[2]));
  EXPECT_TRUE(std::holds_alternative<OpenStep>(options.start[3]));
  EXPECT_TRUE(std::holds_alternative<ConnectedStep>(options.start[4]));
  EXPECT_TRUE(std::holds_alternative<CloseStep>(options.start[5]));
  EXPECT_TRUE(std::holds_alternative<HullStep>(options.start[6]));
  EXPECT_TRUE(std::holds_alternative<FillHolesStep>(options.start[7]));
  EXPECT_TRUE(std::holds_alternative<LargestStep>(options.start[8]));
  EXPECT_EQ(options.seeds.front().name, "liver");
}

TEST(OrganRules, SeedsAreConnectedOnce) {
  OrganRules rules;
  rules.seeds = {Seed{}};
  rules.start = {ConnectedStep{}, GrowStep{1}};
  const OrganOptions options = organ_options(rules);
  EXPECT_EQ(options.start.size(), 2u);
}

TEST(OrganRules, DarkerIsBelowTheLevel) {
  OrganRules rules;
  rules.level = 10;
  rules.darker = true;
  const GreyRange range = std::get<RangeStep>(organ_options(rules).start.front()).range;
  EXPECT_TRUE(std::isinf(range.low));
  EXPECT_EQ(range.high, 10);
}

TEST(OrganRules, ThereIsOneRuleOfGreyValues) {
  OrganRules rules;
  rules.level = 10;
  rules.otsu = true;
  EXPECT_THROW(organ_options(rules), InputError);
  OrganRules turned;
  turned.range = GreyRange{5, 5};
  EXPECT_THROW(organ_options(turned), InputError);
}

}  // namespace
}  // namespace isostack
