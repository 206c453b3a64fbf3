#include "segmentation/start_steps.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"
#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

TEST(StartSteps, TextSaysWhatTheStepDoes) {
  const auto range = std::get<RangeStep>(parse_start_step("range:-20,80"));
  EXPECT_EQ(range.range.low, -20);
  EXPECT_EQ(range.range.high, 80);
  EXPECT_TRUE(std::isinf(std::get<RangeStep>(parse_start_step("level:150")).range.high));
  EXPECT_TRUE(std::isinf(std::get<RangeStep>(parse_start_step("darker:150")).range.low));
  EXPECT_EQ(std::get<GrowStep>(parse_start_step("shrink:2.5")).distance_mm, -2.5);
  EXPECT_FALSE(std::get<OtsuStep>(parse_start_step("otsu")).share);
  EXPECT_EQ(std::get<OtsuStep>(parse_start_step("otsu-darker:0.25")).share, 0.25);
  const auto box = std::get<SolidStep>(parse_start_step("remove-box:1,-2,3,10,20,30"));
  EXPECT_EQ(box.operation, SolidStep::Operation::remove);
  EXPECT_EQ(box.solid.half_size_mm, Eigen::Vector3d(5, 10, 15));
  EXPECT_EQ(box.solid.centre_mm, Eigen::Vector3d(1, -2, 3));
  EXPECT_EQ(std::get<SolidStep>(parse_start_step("add-sphere:0,0,0,4")).solid.half_size_mm,
            Eigen::Vector3d::Constant(4));
}

TEST(StartSteps, WhatCannotBeUnderstoodIsNamedWithWhatItNeeds) {
  for (const std::string text : {"", "opne:3", "open", "open:-3", "open:3,4", "open:x", "range:80,-20", "range:5",
                                 "otsu:2", "fill-holes:1", "gaussian:nan", "keep-cone:1,2,3,4", "keep-sphere:1,2,3",
                                 "keep-sphere:1,2,3,0", "add-box:1,2,3,4,5,", "diffusion:0"}) {
    const auto message = test::message_of<InputError>([&] { parse_start_step(text); });
    EXPECT_NE(message.find("'" + text + "'"), std::string::npos) << text << ": " << message;
    EXPECT_NE(message.find("it needs"), std::string::npos) << text << ": " << message;
  }
}

TEST(Solid, DistancesAreThoseOfBoxAndSphere) {
  const Solid sphere{Solid::Shape::ellipsoid, {1, 2, 3}, {5, 5, 5}};
  EXPECT_NEAR(signed_distance_mm(sphere, {1, 2, 3}), 5, 1e-12);
  EXPECT_NEAR(signed_distance_mm(sphere, {1, 9, 3}), -2, 1e-12);
  const Solid box{Solid::Shape::box, {0, 0, 0}, {1, 2, 3}};
  EXPECT_NEAR(signed_distance_mm(box, {0, 0, 0}), 1, 1e-12);
  EXPECT_NEAR(signed_distance_mm(box, {4, 6, 0}), -5, 1e-12);  // 3-4-5 to the edge
  const Solid ellipsoid{Solid::Shape::ellipsoid, {0, 0, 0}, {10, 4, 4}};
  EXPECT_NEAR(signed_distance_mm(ellipsoid, {10.1, 0, 0}), -0.1, 0.002);  // second order in 0.1 mm
  EXPECT_GT(signed_distance_mm(ellipsoid, {6, 3, 0}), 0);                 // 0.36 + 0.5625 < 1
  EXPECT_LT(signed_distance_mm(ellipsoid, {7, 3, 0}), 0);                 // 0.49 + 0.5625 > 1
}

}  // namespace
}  // namespace isostack
