#include <gtest/gtest.h>

#include <numbers>

#include "recon/geometry/errors.h"
#include "segmentation/segment.h"
#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

using test::Disc;
using test::message_of;
using test::sampled;
using test::stack_of;

void expect_every_pixel_recovered(const Image<float>& labels, int label, const std::vector<Contour>& contours,
                                  const Eigen::Vector2d& spacing_mm = {1, 1}) {
  for (Eigen::Index row = 0; row < labels.rows(); ++row)
    for (Eigen::Index column = 0; column < labels.cols(); ++column)
      ASSERT_EQ(is_inside(contours, Eigen::Vector2d(column, row).cwiseProduct(spacing_mm)),
                labels(row, column) == static_cast<float>(label));
}

TEST(TraceLabel, DigitisedDiscComesBackWithoutStairs) {
  for (const double shift : {0.0, 0.23, 0.5}) {
    const Disc disc{16 + shift, 17 - 0.7 * shift, 10};
    const auto labels = sampled(34, 34, {1, 1}, [&](double x, double y) { return disc(x, y) >= 0 ? 3 : 0; });
    const auto stack = trace_label(stack_of({labels}), 3);
    const auto& contours = stack.slices.at(0).contours;
    ASSERT_EQ(contours.size(), 1u);
    const double area = std::numbers::pi * disc.radius * disc.radius;
    const auto distances = test::distances_to(disc, contours);
    EXPECT_NEAR(signed_area_mm2(contours[0]), area, 0.01 * area);
    EXPECT_LT(distances.mean, 0.2);
    EXPECT_LT(distances.largest, 0.75);
    expect_every_pixel_recovered(labels, 3, contours);
  }
}

TEST(TraceLabel, ThinAndSinglePixelsSurvive) {
  Image<float> labels = Image<float>::Zero(24, 24);
  labels(4, 4) = 1;                                       // alone
  labels.row(10).segment(3, 15) = 1;                      // one pixel wide
  for (int i = 0; i < 6; ++i) labels(14 + i, 4 + i) = 1;  // a diagonal, pixels touch at corners only
  labels.block(15, 15, 6, 6) = 1;
  labels(17, 17) = 0;  // a hole of one pixel
  labels(0, 23) = 1;   // in the image's corner
  const auto stack = trace_label(stack_of({labels}), 1);
  expect_every_pixel_recovered(labels, 1, stack.slices[0].contours);
  int holes = 0;
  for (const Contour& contour : stack.slices[0].contours) holes += contour.depth == 1;
  EXPECT_EQ(holes, 1);
}

TEST(TraceLabel, OnePixelGivesOneContourAroundIt) {
  Image<float> labels = Image<float>::Zero(7, 7);
  labels(3, 2) = 9;
  const auto stack = trace_label(stack_of({labels}, {0.5, 2}), 9);
  ASSERT_EQ(stack.slices[0].contours.size(), 1u);
  EXPECT_GT(signed_area_mm2(stack.slices[0].contours[0]), 0);
  expect_every_pixel_recovered(labels, 9, stack.slices[0].contours, {0.5, 2});
}

TEST(TraceLabel, RandomLabelsComeBackPixelForPixel) {
  std::mt19937 random(5);
  Image<float> labels(40, 30);
  for (float& value : labels.reshaped()) value = static_cast<float>(random() % 3);
  for (const int label : {1, 2}) {
    const auto stack = trace_label(stack_of({labels}, {0.7, 0.9}), label);
    expect_every_pixel_recovered(labels, label, stack.slices[0].contours, {0.7, 0.9});
  }
}

TEST(TraceLabel, SlicesWithoutTheLabelStayEmpty) {
  const auto stack = trace_label(stack_of({Image<float>::Constant(5, 5, 2), Image<float>::Constant(4, 6, 1)}), 2);
  ASSERT_EQ(stack.slices.size(), 2u);
  EXPECT_EQ(stack.slices[0].contours.size(), 1u);
  EXPECT_TRUE(stack.slices[1].contours.empty());
  EXPECT_EQ(stack.slices[1].size_pixels, Eigen::Vector2i(6, 4));
}

TEST(TraceLabel, MissingLabelListsThosePresent) {
  const auto stack = stack_of({Image<float>::Constant(3, 3, 7), Image<float>::Constant(3, 3, 2)});
  EXPECT_EQ(labels_in(stack), (std::vector<int>{2, 7}));
  const auto message = message_of<InputError>([&] { trace_label(stack, 5); });
  EXPECT_NE(message.find("label 5"), std::string::npos) << message;
  EXPECT_NE(message.find("2, 7"), std::string::npos) << message;
  EXPECT_THROW(trace_label(stack_of({Image<float>::Zero(3, 3)}), 1), InputError);
}

TEST(LabelsIn, RefusesGreyValues) {
  for (const float value : {0.5f, std::numeric_limits<float>::quiet_NaN(), 1e20f}) {
    const auto message = message_of<InputError>([&] { labels_in(stack_of({Image<float>::Constant(2, 2, value)})); });
    EXPECT_NE(message.find("slice 0"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace isostack
