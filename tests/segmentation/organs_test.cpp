#include "segmentation/organs.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "recon/geometry/errors.h"
#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

using test::Disc;
using test::message_of;
using test::sampled;
using test::stack_of;

constexpr double pi = std::numbers::pi;

/// Grey values with an edge about a pixel wide, 20 outside, `inside` within.
double grey(double distance, double inside = 100) { return 20 + (inside - 20) * (1 + std::tanh(distance)) / 2; }

/// Balls of radius 18 at (20, 32) and (58, 32), which touch, on 15 slices 3 mm apart; their middle is slice 7.
SliceStack two_balls(double noise = 0) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal(0, 1);
  std::vector<Image<float>> images;
  for (int k = 0; k < 15; ++k) {
    const double z = 3.0 * (k - 7), r = z * z < 324 ? std::sqrt(324 - z * z) : 0;
    images.push_back(sampled(64, 80, {1, 1}, [&](double x, double y) {
      const double a = r > 0 ? Disc{20, 32, r}(x, y) : -10, b = r > 0 ? Disc{58, 32, r}(x, y) : -10;
      return grey(std::max(a, b)) + noise * normal(random);
    }));
  }
  return stack_of(images);
}

const Seed left{{20, 32, 21}, "left"}, right{{58, 32, 21}, "right"};

double volume_mm3(const ContourStack& organ) {
  double volume = 0;
  for (const ContourSlice& slice : organ.slices) volume += 3 * test::total_area_mm2(slice.contours);
  return volume;
}

TEST(SegmentOrgans, SeedsPartBallsThatTouchAndEmptySlicesStayEmpty) {
  const auto found = segment_organs(two_balls(5), {.start = {RangeStep{{60, 1000}}}, .seeds = {left, right}});
  ASSERT_EQ(found.organs.size(), 2u);
  EXPECT_EQ(found.organs[0].name, "left");
  EXPECT_EQ(found.organs[1].name, "right");
  for (const ContourStack& organ : found.organs) {
    EXPECT_NEAR(volume_mm3(organ), 4.0 / 3 * pi * 5832, 0.04 * 24429);  // slices of 3 mm, noise, the neck
    EXPECT_TRUE(organ.slices[0].contours.empty());
    EXPECT_TRUE(organ.slices[14].contours.empty());
    EXPECT_FALSE(organ.slices[2].contours.empty());
  }
}

TEST(SegmentOrgans, OrgansShareNoPixel) {
  OrganOptions options{.start = {RangeStep{{60, 1000}}, CloseStep{4}}, .seeds = {left, right}};
  options.evolution.curvature = 1;
  const auto found = segment_organs(two_balls(10), options);
  for (std::size_t k = 0; k < 15; ++k)
    for (int row = 0; row < 64; ++row)
      for (int column = 0; column < 80; ++column) {
        const Eigen::Vector2d at(column, row);
        ASSERT_FALSE(is_inside(found.organs[0].slices[k].contours, at) &&
                     is_inside(found.organs[1].slices[k].contours, at));
      }
}

TEST(SegmentOrgans, WhatIsNotWantedBoundsButIsNotReturned) {
  const Seed unwanted{right.position_mm, "-"};
  const auto found = segment_organs(
      two_balls(), {.start = {RangeStep{{60, 1000}}, ConnectedStep{}, FillHolesStep{}}, .seeds = {left, unwanted}});
  ASSERT_EQ(found.organs.size(), 1u);
  EXPECT_NEAR(volume_mm3(found.organs[0]), 4.0 / 3 * pi * 5832, 0.04 * 24429);
}

TEST(SegmentOrgans, SeedsAloneTellTheGreyValues) {
  // A dark and a bright disc with sharp edges: each seed finds its own.
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 6);
  const auto image = sampled(64, 80, {1, 1}, [&](double x, double y) {
    return (Disc{20, 32, 14}(x, y) > 0 ? 100 : Disc{58, 32, 14}(x, y) > 0 ? 0 : 50) + noise(random);
  });
  OrganOptions options{.start = {SeedRangeStep{3}, ConnectedStep{}, CloseStep{1.5}}, .seeds = {left, right}};
  options.seeds[0].position_mm.z() = options.seeds[1].position_mm.z() = 0;
  options.evolution.curvature = 1;
  const auto found = segment_organs(stack_of({image}), options);
  for (const ContourStack& organ : found.organs)  // the edge of the range is nearer to the disc than half its height
    EXPECT_NEAR(test::total_area_mm2(organ.slices[0].contours), pi * 196, 0.1 * pi * 196);
}

TEST(SegmentOrgans, PropagationFollowsAnOrganThatMovesAndStopsWhereItRunsOut) {
  // A disc moving by 4 mm a slice; on slice 6 it joins a large bright area; slice 0 has something else far away.
  std::vector<Image<float>> images;
  for (int k = 0; k < 8; ++k)
    images.push_back(sampled(64, 96, {1, 1}, [&](double x, double y) {
      double distance = Disc{24 + 4.0 * k, 30, 10}(x, y);
      if (k == 0) distance = Disc{80, 50, 8}(x, y);
      if (k == 6) distance = std::max(distance, 30 - std::hypot(x - 60, y - 30));
      return grey(distance);
    }));
  const auto found = segment_organs(
      stack_of(images), {.start = {RangeStep{{60, 1000}}}, .seeds = {{{36, 30, 9}, "worm"}}, .propagate_mm = 6});
  ASSERT_EQ(found.organs.size(), 1u);
  const auto& slices = found.organs[0].slices;
  EXPECT_TRUE(slices[0].contours.empty());
  for (std::size_t k = 1; k < 6; ++k) {
    ASSERT_EQ(slices[k].contours.size(), 1u) << k;
    EXPECT_NEAR(signed_area_mm2(slices[k].contours[0]), pi * 100, 0.02 * pi * 100) << k;
  }
  EXPECT_TRUE(slices[6].contours.empty());
  EXPECT_TRUE(slices[7].contours.empty());
  ASSERT_EQ(found.remarks.size(), 1u);
  EXPECT_NE(found.remarks[0].find("worm"), std::string::npos);
  EXPECT_NE(found.remarks[0].find("slice 6"), std::string::npos);
}

TEST(SegmentOrgans, VolumeFindsTheBallWithItsDistance) {
  const Solid ball{Solid::Shape::ellipsoid, {20, 32, 21}, {25, 25, 25}};
  OrganOptions options{.start = {RangeStep{{60, 1000}}, SolidStep{SolidStep::Operation::keep, ball}}};
  options.seeds = {left};
  options.in_volume = true;
  options.keep_distances = true;
  options.evolution.curvature = 0.5;
  const auto found = segment_organs(two_balls(8), options);
  // The neighbour's near cap within the sphere of 25 mm is the ball's to a few per cent.
  EXPECT_NEAR(volume_mm3(found.organs[0]), 4.0 / 3 * pi * 5832, 0.1 * 24429);
  EXPECT_NEAR(found.distances_mm[0][7](32, 4), 2, 0.4);  // 16 mm left of the centre
  EXPECT_NEAR(found.distances_mm[0][7](32, 0), -2, 0.4);
}

TEST(SegmentOrgans, SolidsAndLabelsCanStartWithoutGreyValues) {
  const auto stack = stack_of({Image<float>::Zero(40, 40)});
  const Solid ball{Solid::Shape::ellipsoid, {20, 20, 0}, {10, 10, 10}}, box{Solid::Shape::box, {20, 20, 0}, {30, 4, 4}};
  const auto cut = segment_organs(
      stack, {.start = {SolidStep{SolidStep::Operation::add, ball}, SolidStep{SolidStep::Operation::remove, box}}});
  EXPECT_EQ(cut.organs[0].slices[0].contours.size(), 2u);
  Grid grid;
  grid.size = {40, 40, 1};
  auto labels = std::make_shared<Volume<float>>(grid);
  for (int j = 10; j < 20; ++j)
    for (int i = 5; i < 25; ++i) labels->at(i, j, 0) = 3;
  const auto block = segment_organs(stack, {.start = {LabelStep{labels, 3}}});
  EXPECT_NEAR(test::total_area_mm2(block.organs[0].slices[0].contours), 200, 1);  // four corners cut
  EXPECT_THROW(segment_organs(stack, {.start = {LabelStep{labels, 3}, GaussianStep{1}}}), InputError);
}

TEST(SegmentOrgans, BadInputIsNamedWithWhatToTry) {
  const auto stack = two_balls();
  const OrganOptions seeded{.start = {RangeStep{{60, 1000}}}, .seeds = {left}};
  const auto refusal = [&](const SliceStack& input, const OrganOptions& options) {
    return message_of<InputError>([&] { segment_organs(input, options); });
  };
  const auto expect_words = [](const std::string& message, const std::vector<std::string>& words) {
    for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << ": " << message;
  };
  OrganOptions beside = seeded;
  beside.seeds[0].position_mm.x() = -30;
  expect_words(refusal(stack, beside), {"seed -30,32,21 (left)", "beside", "LPS"});
  beside.seeds[0].position_mm = {20, 32, 500};
  expect_words(refusal(stack, beside), {"458", "slice 14"});
  OrganOptions in_air = seeded;
  in_air.seeds[0].position_mm = {40, 5, 21};
  expect_words(refusal(stack, in_air), {"slice 7", "grey value is 20", "--range"});
  OrganOptions too_open = seeded;
  too_open.start.push_back(OpenStep{30});
  expect_words(refusal(stack, too_open), {"left", "--open"});

  const auto constant = stack_of({Image<float>::Constant(30, 30, 7)});
  expect_words(refusal(constant, {.start = {OtsuStep{}}}), {"test stack", "constant"});
  expect_words(refusal(constant, {.start = {}, .seeds = {{{5, 5, 0}, ""}}}), {"slice 0", "constant"});
  auto broken = stack;
  broken.slices[3].pixels(1, 1) = std::numeric_limits<float>::infinity();
  expect_words(refusal(broken, seeded), {"slice 3", "finite"});
  broken = stack;
  broken.slices[2].pose.spacing_mm.x() = 0;
  expect_words(refusal(broken, seeded), {"slice 2", "spacing", "--spacing"});
  expect_words(refusal(stack, {}), {"nothing says where the organ is"});
}

TEST(SegmentOrgans, EvolutionThatVanishesOrFloodsIsNamed) {
  const auto stack = two_balls();
  OrganOptions shrinking{.start = {RangeStep{{60, 1000}}}};
  shrinking.evolution = {.range_weight = 0.0, .balloon = -1, .max_steps = 200};
  const auto vanished = message_of<InputError>([&] { segment_organs(stack, shrinking); });
  EXPECT_NE(vanished.find("vanish"), std::string::npos) << vanished;
  EXPECT_NE(vanished.find("slice "), std::string::npos) << vanished;
  OrganOptions growing = shrinking;
  growing.evolution.balloon = 1;
  const auto flooded = message_of<InputError>([&] { segment_organs(stack, growing); });
  EXPECT_NE(flooded.find("floods"), std::string::npos) << flooded;
  growing.evolution.stay_mm = 2;
  const auto found = segment_organs(stack, growing);
  // Both discs of the middle slice grow by 2 mm and meet.
  EXPECT_NEAR(test::total_area_mm2(found.organs[0].slices[7].contours), 2 * pi * 400, 0.03 * 2 * pi * 400);
}

TEST(SegmentOrgans, VolumeNeedsEvenSpacing) {
  auto stack = two_balls();
  stack.slices[4].pose.origin_mm.z() += 1;
  OrganOptions options{.start = {RangeStep{{60, 1000}}}};
  options.in_volume = true;
  const auto message = message_of<GeometryError>([&] { segment_organs(stack, options); });
  EXPECT_NE(message.find("slice 4"), std::string::npos) << message;
}

}  // namespace
}  // namespace isostack
