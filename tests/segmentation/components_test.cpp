#include "segmentation/components.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"
#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

Mask mask_of(const std::vector<std::string>& rows) {
  Mask mask(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows.front().size()));
  for (Eigen::Index row = 0; row < mask.rows(); ++row)
    for (Eigen::Index column = 0; column < mask.cols(); ++column)
      mask(row, column) = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '#';
  return mask;
}

void expect_same(const Mask& a, const Mask& b) {
  EXPECT_TRUE((a == b).all()) << a.cast<int>() << "\n\n" << b.cast<int>();
}

TEST(FillHoles, FillsWhatDoesNotReachTheBorder) {
  expect_same(fill_holes(mask_of({".......",  //
                                  ".####..",  //
                                  ".#..#..",  //
                                  ".#.##..",  //
                                  "..####.",  //
                                  "..#..##",  //
                                  "..#..#."})),
              mask_of({".......",  //
                       ".####..",  //
                       ".####..",  //
                       ".####..",  //
                       "..####.",  //
                       "..#..##",  // the bay is open at the lower border
                       "..#..#."}));
}

TEST(FillHoles, DiagonalGapDoesNotOpenAHole) {
  expect_same(fill_holes(mask_of({".....",  //
                                  ".##..",  //
                                  ".#.#.",  //
                                  ".###.",  //
                                  "....."})),
              mask_of({".....",  //
                       ".##..",  //
                       ".###.",  //
                       ".###.",  //
                       "....."}));
}

TEST(FillHoles, EmptyAndFullStay) {
  expect_same(fill_holes(Mask::Zero(3, 4)), Mask::Zero(3, 4));
  expect_same(fill_holes(Mask::Ones(3, 4)), Mask::Ones(3, 4));
}

TEST(LargestComponent, ConnectsThroughPlanesButNotDiagonally) {
  // Left: 2 + 2 pixels above each other. Right: 3 pixels in plane 0, 2 more only diagonally below.
  const auto kept = largest_component({mask_of({"##..###", "......."}), mask_of({"##.#...", "....###"})});
  expect_same(kept[0], mask_of({"##.....", "......."}));
  expect_same(kept[1], mask_of({"##.....", "......."}));
}

TEST(LargestComponent, NothingStaysNothing) { EXPECT_EQ(largest_component({Mask::Zero(3, 3)})[0].count(), 0); }

TEST(LargestComponent, SizesMustAgree) {
  EXPECT_THROW(largest_component({Mask::Zero(3, 3), Mask::Zero(3, 4)}), GeometryError);
}

TEST(StackingOrder, SortsAlongTheNormalAndAllowsGaps) {
  SliceStack stack = test::stack_of(std::vector<Image<float>>(3, Image<float>::Zero(4, 4)));
  stack.slices[0].pose.origin_mm.z() = 20;
  EXPECT_EQ(stacking_order(stack), (std::vector<std::size_t>{1, 2, 0}));
}

TEST(StackingOrder, RefusesSlicesWhosePixelsDoNotLieAboveEachOther) {
  const auto refused = [](auto change) {
    SliceStack stack = test::stack_of(std::vector<Image<float>>(2, Image<float>::Zero(4, 4)));
    change(stack.slices[1]);
    return test::message_of<GeometryError>([&] { stacking_order(stack); });
  };
  const std::string message = refused([](Slice& slice) {
    slice.pose.x_axis = Eigen::Vector3d::UnitY();
    slice.pose.y_axis = Eigen::Vector3d::UnitZ();
  });
  EXPECT_NE(message.find("slice 1"), std::string::npos) << message;
  EXPECT_NE(message.find("leave out `largest`"), std::string::npos) << message;
  EXPECT_NE(refused([](Slice& slice) { slice.pixels.resize(4, 5); }), "");
  EXPECT_NE(refused([](Slice& slice) { slice.pose.spacing_mm = {1, 2}; }), "");
}

}  // namespace
}  // namespace isostack
