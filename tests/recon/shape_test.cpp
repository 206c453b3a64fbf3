#include "recon/morphing/shape.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/figures.h"

namespace isostack {
namespace {

using testing_support::disc;

/// What the refusal of these two shapes says.
std::string refusal(const KeyShape& a, const KeyShape& b) {
  try {
    require_morphable({a, b});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

KeyShape first() { return disc("first", {50, 50}, 20); }
KeyShape second() { return disc("second", {40, 50}, 10); }
ContourSlice& figure(KeyShape& shape) { return std::get<ContourSlice>(shape.shape); }

testing::AssertionResult says(const std::string& message, const std::string& who, const std::string& what) {
  if (message.find(who) == 0 && message.find(what) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << message << "\" does not begin with " << who << " or lacks " << what;
}

TEST(RequireMorphable, TakesFiguresOfOnePlaneWhereverTheirImagesBegin) {
  KeyShape shifted = second();
  figure(shifted).pose.origin_mm = {7, -3, 0};
  EXPECT_EQ(refusal(first(), shifted), "");
}

TEST(RequireMorphable, NamesTheShapeWhosePixelsDiffer) {
  KeyShape other = second();
  figure(other).pose.spacing_mm = {2, 2};
  EXPECT_TRUE(says(refusal(first(), other), "second", "pixels"));
}

TEST(RequireMorphable, NamesTheShapeInAnotherPlane) {
  KeyShape other = second();
  figure(other).pose.origin_mm.z() = 5;
  EXPECT_TRUE(says(refusal(first(), other), "second", "5 mm off"));
}

TEST(RequireMorphable, NamesTheShapeWhoseAxesDiffer) {
  KeyShape other = second();
  std::swap(figure(other).pose.x_axis, figure(other).pose.y_axis);
  EXPECT_TRUE(says(refusal(first(), other), "second", "axes"));
}

TEST(RequireMorphable, NamesTheEmptyShape) {
  KeyShape other = second();
  figure(other).contours.clear();
  EXPECT_TRUE(says(refusal(first(), other), "second", "nothing"));
  figure(other).contours = {{.points_mm = {{1, 1}, {2, 2}, {3, 3}}}};  // encloses no area
  EXPECT_TRUE(says(refusal(first(), other), "second", "nothing"));
}

TEST(RequireMorphable, NamesTheShapeWithAPointThatIsNoNumber) {
  KeyShape other = second();
  figure(other).contours.push_back({.points_mm = {{1, 1}, {2, std::nan("")}, {3, 3}}});
  EXPECT_TRUE(says(refusal(first(), other), "second", "not a number"));
}

TEST(RequireMorphable, NamesTheImageThatDoesNotFitItsFigure) {
  KeyShape other = second();
  figure(other).size_pixels = {100, 80};
  other.image = GreyFigure{Image<float>::Zero(100, 80), 0.5};  // rows and columns swapped
  EXPECT_TRUE(says(refusal(first(), other), "second", "different sizes"));
}

TEST(RequireMorphable, NamesTheOpenMesh) {
  const KeyShape ball{.name = "ball", .shape = testing_support::sphere_mesh({0, 0, 0}, 10, 20, 10)};
  KeyShape open = ball;
  open.name = "open";
  std::get<TriangleMesh>(open.shape).triangles.pop_back();
  EXPECT_EQ(refusal(ball, ball), "");
  EXPECT_TRUE(says(refusal(ball, open), "open", "on one side only"));
}

TEST(RequireMorphable, WantsTwoShapesOfOneKind) {
  const KeyShape ball{.name = "ball", .shape = testing_support::sphere_mesh({0, 0, 0}, 10, 20, 10)};
  EXPECT_TRUE(says(refusal(first(), ball), "ball", "body"));
  EXPECT_THROW(require_morphable({first()}), InputError);
  EXPECT_THROW(require_morphable({}), InputError);
}

TEST(BoxOfShapes, IsInTheFirstFiguresPose) {
  KeyShape shifted = second();  // from 30 to 50 in its own frame
  figure(shifted).pose.origin_mm = {7, 0, 0};
  const Eigen::AlignedBox3d box = box_of(std::vector{first(), shifted});
  EXPECT_NEAR(box.min().x(), 30, 0.01);  // first: from 30; second: from 37
  EXPECT_NEAR(box.max().x(), 70, 0.01);
}

}  // namespace
}  // namespace isostack
