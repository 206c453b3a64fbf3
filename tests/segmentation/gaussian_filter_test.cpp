#include "segmentation/gaussian_filter.h"

#include <gtest/gtest.h>

#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

TEST(GaussianFilter, ImpulseHasTheAskedVarianceAlongEachAxis) {
  Image<float> image = Image<float>::Zero(41, 51);
  image(20, 25) = 1;
  const Image<float> blurred = gaussian_filter_mm(image, 2, {1, 0.8});  // sigma 2 columns, 2.5 rows
  double sum = 0, variance_x = 0, variance_y = 0;
  for (int row = 0; row < 41; ++row)
    for (int column = 0; column < 51; ++column) {
      sum += blurred(row, column);
      variance_x += blurred(row, column) * std::pow(column - 25, 2);
      variance_y += blurred(row, column) * std::pow(row - 20, 2);
    }
  EXPECT_NEAR(sum, 1, 1e-5);
  // Cutting the tail at four sigmas loses about 0.1 % of the variance.
  EXPECT_NEAR(variance_x, 4, 0.01);
  EXPECT_NEAR(variance_y, 6.25, 0.015);
}

TEST(GaussianFilter, ConstantsStayUpToTheBorder) {
  const Image<float> image = Image<float>::Constant(5, 3, -1000);
  EXPECT_LT((gaussian_filter(image, {3, 3}) - image).abs().maxCoeff(), 1e-3f);  // float rounding of 1000
}

TEST(GaussianFilter, ZeroSigmaLeavesTheAxisAlone) {
  const auto image = test::sampled(6, 7, {1, 1}, [](double x, double y) { return std::sin(3 * x) * y; });
  EXPECT_TRUE((gaussian_filter(image, {0, 0}) == image).all());
  const auto constant_along_x = test::sampled(6, 7, {1, 1}, [](double, double y) { return std::sin(3 * y); });
  EXPECT_LT((gaussian_filter(constant_along_x, {2, 0}) - constant_along_x).abs().maxCoeff(), 1e-6f);
}

}  // namespace
}  // namespace isostack
