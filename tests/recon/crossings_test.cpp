#include "recon/constraints/crossings.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_shapes.h"
#include "tests/support/crossing_slices.h"

namespace isostack {
namespace {

using testing_support::cardiac_slices;
using testing_support::circle;
using testing_support::orthogonal_slices;
using testing_support::sphere_cuts;

// A circle of 400 points deviates from its radius by 20 (1 − cos(π / 400)) = 0.0006 mm.
constexpr double polygon_mm = 0.01;

/// A circle of radius 20 about the world origin in the plane z = 0, and one about (shift, 0, 0) in y = 0.
ContourStack two_circles(double shift_mm) {
  ContourStack stack{.name = "two", .slices = std::vector<ContourSlice>(2)};
  stack.slices[0].name = "flat";
  stack.slices[1].name = "upright";
  stack.slices[1].pose.y_axis = Eigen::Vector3d::UnitZ();
  stack.slices[0].contours = {circle({0, 0}, 20, 400)};
  stack.slices[1].contours = {circle({shift_mm, 0}, 20, 400)};
  return stack;
}

TEST(Crossings, ShiftedCircleDisagreesByItsShiftAtBothEnds) {
  const Contradictions found = find_contradictions(two_circles(2));
  ASSERT_EQ(found.pairs.size(), 1u);
  const SlicePair& pair = found.pairs[0];
  EXPECT_EQ(pair.first_name, "flat");
  EXPECT_EQ(pair.second_name, "upright");
  EXPECT_NEAR(pair.disagreement_mm, 4, polygon_mm);
  EXPECT_NEAR(pair.largest_mismatch_mm, 2, polygon_mm);
  EXPECT_NEAR(pair.line_mm, 1.2 * 42, polygon_mm);  // both contours reach from −20 to 22, and a tenth each way
  ASSERT_EQ(pair.places.size(), 2u);
  for (const Contradiction& place : pair.places) {
    EXPECT_TRUE(place.is_matched());
    EXPECT_NEAR(place.distance_mm, 2, polygon_mm);
    EXPECT_NEAR(place.middle_mm().tail<2>().norm(), 0, 1e-9);  // the planes meet in the x axis
  }
  EXPECT_NEAR(pair.places[0].middle_mm().x() * pair.places[1].middle_mm().x(), -19 * 21, 1);
}

TEST(Crossings, ConsistentSlicesAgree) {
  for (const ContourStack& stack : {orthogonal_slices(), cardiac_slices()}) {
    const Contradictions found = find_contradictions(stack);
    EXPECT_GT(found.pairs.size(), 40u);
    EXPECT_LT(found.largest_mismatch_mm(), 0.05);  // chords of 240-point polygons, cut obliquely
  }
}

TEST(Crossings, AMissedPieceIsAContradictionWithoutMatch) {
  ContourStack stack = two_circles(0);
  stack.slices[0].contours.push_back(circle({30, 0}, 4, 200));
  const Contradictions found = find_contradictions(stack);
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_NEAR(found.disagreement_mm(), 8, polygon_mm);
  EXPECT_FALSE(found.pairs[0].places.back().is_matched() && found.pairs[0].places.front().is_matched());
}

TEST(Crossings, NothingIsSaidBeyondAnImage) {
  ContourStack stack = two_circles(2);
  stack.slices[1].size_pixels = {15, 15};  // x and z from 0 to 14 mm: within both circles
  EXPECT_EQ(find_contradictions(stack).disagreement_mm(), 0);
  stack.slices[1].size_pixels = {31, 31};  // to 30 mm: only the end at +20, +22 is seen
  EXPECT_NEAR(find_contradictions(stack).disagreement_mm(), 2, polygon_mm);
}

TEST(Crossings, AnEmptySliceSaysOutside) {
  ContourStack stack = two_circles(0);
  stack.slices[1].contours.clear();
  EXPECT_NEAR(find_contradictions(stack).disagreement_mm(), 40, polygon_mm);
}

TEST(Crossings, PlanesThatCrossOutsideBothOrNotAtAllSayNothing) {
  ContourStack stack = two_circles(0);
  stack.slices[1].pose.origin_mm = {0, 30, 50};  // meets the flat plane in y = 30, 30 mm below its own circle
  EXPECT_TRUE(find_contradictions(stack).pairs.empty());
  EXPECT_TRUE(find_contradictions(sphere_cuts(40, {}, {-10, 0, 10}, 100)).pairs.empty());
  EXPECT_TRUE(find_contradictions({}).pairs.empty());
}

TEST(Crossings, OnePlaneTwiceMustShowTheSame) {
  ContourStack stack = two_circles(0);
  stack.slices.push_back(stack.slices[0]);
  stack.slices[2].name = "again";
  stack.slices[2].contours = {circle({0.5, 0}, 20, 400)};  // half a pixel: drawn twice by hand
  EXPECT_NO_THROW(find_contradictions(stack));
  stack.slices[2].contours = {circle({3, 0}, 20, 400)};
  try {
    find_contradictions(stack);
    FAIL() << "accepted";
  } catch (const GeometryError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("flat"), std::string::npos) << message;
    EXPECT_NE(message.find("again"), std::string::npos) << message;
    EXPECT_NE(message.find("3.0 mm"), std::string::npos) << message;
  }
  stack.slices[2].contours.clear();
  EXPECT_THROW(find_contradictions(stack), GeometryError);
}

}  // namespace
}  // namespace isostack
