#include "segmentation/segment.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <numbers>
#include <thread>

#include "recon/geometry/errors.h"
#include "tests/segmentation/shapes.h"

namespace isostack {
namespace {

using test::Disc;
using test::message_of;
using test::sampled;
using test::stack_of;

/// Grey value 100 inside, 20 outside, blurred edge; 60 lies on the circle.
double grey(double distance) { return 60 + 40 * std::tanh(distance); }

Image<float> disc_image(const Disc& disc, double noise = 0, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  return sampled(64, 64, {1, 1}, [&](double x, double y) { return grey(disc(x, y)) + noise * normal(random); });
}

const Disc disc{31.3, 32.1, 18};

TEST(Segment, ThresholdFollowsTheEdgeBelowAPixel) {
  const auto stack = segment(stack_of({disc_image(disc), Image<float>::Constant(20, 30, 20)}), {.level = 60});
  ASSERT_EQ(stack.slices.size(), 2u);
  EXPECT_EQ(stack.name, "test stack");
  EXPECT_EQ(stack.slices[0].name, "slice 0");
  EXPECT_EQ(stack.slices[0].size_pixels, Eigen::Vector2i(64, 64));
  EXPECT_EQ(stack.slices[1].size_pixels, Eigen::Vector2i(30, 20));
  EXPECT_EQ(stack.slices[1].pose.origin_mm.z(), 3);
  EXPECT_TRUE(stack.slices[1].contours.empty());
  ASSERT_EQ(stack.slices[0].contours.size(), 1u);
  const auto& contours = stack.slices[0].contours;
  EXPECT_LT(test::distances_to(disc, contours).largest, 0.05);  // tanh against linear interpolation
  EXPECT_NEAR(test::total_area_mm2(contours), std::numbers::pi * 18 * 18, 0.005 * std::numbers::pi * 18 * 18);
}

TEST(Segment, DarkerInsideIsTheSameOrganInANegative) {
  const Image<float> bright = disc_image(disc);
  const auto a = segment(stack_of({bright}), {.level = 60});
  const auto b = segment(stack_of({Image<float>(120 - bright)}), {.level = 60, .brighter_inside = false});
  ASSERT_EQ(b.slices[0].contours.size(), 1u);
  EXPECT_NEAR(test::total_area_mm2(a.slices[0].contours), test::total_area_mm2(b.slices[0].contours), 1e-3);
  const auto outside = segment(stack_of({bright}), {.level = 60, .brighter_inside = false});
  EXPECT_EQ(outside.slices[0].contours.size(), 2u);  // the image's border and the disc as a hole
}

TEST(Segment, CurvatureWithstandsNoise) {
  const double contrast = 80, cnr = 4;
  const auto noisy = stack_of({disc_image(disc, contrast / cnr)});
  const auto raw = segment(noisy, {.level = 60});
  const auto smooth = segment(noisy, {.level = 60, .curvature = 2, .max_steps = 300});
  EXPECT_GT(raw.slices[0].contours.size(), 5u);
  ASSERT_EQ(smooth.slices[0].contours.size(), 1u);
  EXPECT_LT(test::distances_to(disc, smooth.slices[0].contours).mean, 0.3);
}

TEST(Segment, GaussianRemovesNoiseAndUsesTheSmallerPixelSpacing) {
  const auto smooth = segment(stack_of({disc_image(disc, 20)}), {.level = 60, .gaussian_sigma_pixels = 1.5});
  ASSERT_EQ(smooth.slices[0].contours.size(), 1u);
  EXPECT_LT(test::distances_to(disc, smooth.slices[0].contours).mean, 0.3);
}

TEST(Segment, FillHolesAndLargestKeepTheOtherCurvesWhereTheyWere) {
  // A ring with a hole, and a separate small disc that only the first slice has.
  const auto ring = [](double x, double y) {
    const double r = std::hypot(x - 24, y - 30);
    return std::min(17.3 - r, r - 6.2);
  };
  const auto first = sampled(
      64, 64, {1, 1}, [&](double x, double y) { return grey(std::max(ring(x, y), 5.4 - std::hypot(x - 54, y - 30))); });
  const auto second = sampled(64, 64, {1, 1}, [&](double x, double y) { return grey(ring(x, y)); });
  const auto input = stack_of({first, second});
  const auto plain = segment(input, {.level = 60});
  ASSERT_EQ(plain.slices[0].contours.size(), 3u);
  const auto clean = segment(input, {.level = 60, .fill_holes = true, .largest = true});
  for (const ContourSlice& slice : clean.slices) {
    ASSERT_EQ(slice.contours.size(), 1u);
    EXPECT_EQ(slice.contours[0].points_mm, plain.slices[0].contours[0].points_mm);
  }
  EXPECT_EQ(segment(input, {.level = 60, .fill_holes = true}).slices[0].contours.size(), 2u);
  EXPECT_EQ(segment(input, {.level = 60, .largest = true}).slices[0].contours.size(), 2u);
}

TEST(Segment, LargestNeedsSlicesAboveEachOther) {
  auto input = stack_of({disc_image(disc), disc_image(disc)});
  input.slices[1].pose.y_axis = Eigen::Vector3d::UnitZ();
  EXPECT_THROW(segment(input, {.level = 60, .largest = true}), GeometryError);
  EXPECT_EQ(segment(input, {.level = 60}).slices.size(), 2u);
}

TEST(Segment, LevelNoPixelCrossesIsExplained) {
  const auto input = stack_of({disc_image(disc)});
  for (const double level : {500.0, 3.0}) {
    const auto message = message_of<InputError>([&] { segment(input, {.level = level}); });
    EXPECT_NE(message.find("test stack"), std::string::npos) << message;
    EXPECT_NE(message.find("level " + std::string(level > 100 ? "500" : "3")), std::string::npos) << message;
    EXPECT_NE(message.find("from 20 to 100"), std::string::npos) << message;
    const double suggested = std::stod(message.substr(message.find("try level ") + 10));
    EXPECT_NEAR(suggested, 60, 5) << message;  // the middle of both classes' means
  }
  EXPECT_NE(message_of<InputError>([&] { segment(stack_of({Image<float>::Zero(3, 3)}), {.level = 1}); }), "");
  EXPECT_NE(message_of<InputError>([&] { segment(input, {.level = 3, .brighter_inside = false}); }), "");
}

TEST(Segment, BadInputNamesTheSlice) {
  auto input = stack_of({disc_image(disc), disc_image(disc)});
  input.slices[1].pixels(4, 5) = std::numeric_limits<float>::quiet_NaN();
  const auto message = message_of<InputError>([&] { segment(input, {.level = 60}); });
  EXPECT_NE(message.find("slice 1"), std::string::npos) << message;
  EXPECT_THROW(segment(SliceStack{}, {.level = 60}), InputError);
  EXPECT_THROW(segment(stack_of({Image<float>()}), {.level = 60}), InputError);
  EXPECT_THROW(segment(stack_of({disc_image(disc)}), {.level = 60, .curvature = -1}), InputError);
  EXPECT_THROW(segment(stack_of({disc_image(disc)}), {.level = std::nan("")}), InputError);
}

TEST(Segment, ReportsFromTheCallingThreadAndCancels) {
  const auto input = stack_of(std::vector<Image<float>>(20, disc_image(disc)));
  const auto caller = std::this_thread::get_id();
  double last = -1;
  Progress progress;
  progress.on_report = [&](std::string_view stage, double fraction) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(stage, "segment");
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  segment(input, {.level = 60}, progress);
  EXPECT_EQ(last, 1);
  progress.on_report = {};
  progress.is_cancelled = [] { return true; };
  EXPECT_THROW(segment(input, {.level = 60}, progress), Cancelled);
}

TEST(Segment, DoesNotDependOnTheNumberOfThreads) {
  std::vector<Image<float>> images;
  for (unsigned seed = 0; seed < 6; ++seed) images.push_back(disc_image(disc, 20, seed));
  const SegmentationOptions options{.level = 60, .curvature = 1, .fill_holes = true, .largest = true};
  const auto parallel = segment(stack_of(images), options);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto serial = segment(stack_of(images), options);
  for (std::size_t i = 0; i < images.size(); ++i) {
    ASSERT_EQ(parallel.slices[i].contours.size(), serial.slices[i].contours.size());
    for (std::size_t k = 0; k < serial.slices[i].contours.size(); ++k)
      EXPECT_EQ(parallel.slices[i].contours[k].points_mm, serial.slices[i].contours[k].points_mm);
  }
}

}  // namespace
}  // namespace isostack
