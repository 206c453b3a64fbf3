// What becomes of bad input and of evolutions that lose their curve; independence of threads.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <limits>
#include <random>

#include "recon/geometry/errors.h"
#include "segmentation/level_set.h"
#include "segmentation/region_term.h"
#include "tests/segmentation/fields.h"

namespace isostack {
namespace {

using test::field_from;

Field<2> disc(double radius) {
  return field_from<2>({30, 30}, {1, 1}, [=](const auto& p) { return radius - (p - Eigen::Vector2d(15, 14)).norm(); });
}

TEST(LevelSetOutcome, VanishedAndFloodedAreTold) {
  ConstantTerm<2> shrink(-1), grow(1);
  const auto gone = evolve<2>(disc(5), {&shrink});
  EXPECT_EQ(gone.stop, LevelSetStop::vanished);
  EXPECT_NEAR(gone.time_mm, 5, 1);  // the last step takes the rest
  const auto full = evolve<2>(disc(5), {&grow});
  EXPECT_EQ(full.stop, LevelSetStop::flooded);
  EXPECT_GE(*std::min_element(full.phi.values.begin(), full.phi.values.end()), 0);
  EXPECT_EQ(evolve<2>(field_from<2>({4, 4}, {1, 1}, [](const auto&) { return -1; }), {&grow}).stop,
            LevelSetStop::vanished);
  EXPECT_EQ(evolve<2>(field_from<2>({4, 4}, {1, 1}, [](const auto&) { return 1; }), {&grow}).stop,
            LevelSetStop::flooded);
}

TEST(LevelSetOutcome, SpacingAndStartAreChecked) {
  ConstantTerm<2> grow(1);
  auto start = disc(5);
  start.spacing_mm[1] = 0;
  EXPECT_THROW(evolve<2>(start, {&grow}), InputError);
  start = disc(5);
  start.values[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(evolve<2>(start, {&grow}), InputError);
}

TEST(LevelSetOutcome, NotANumberNextToTheCurveStopsTheEvolution) {
  auto image = disc(8);
  image.values[image.node_at({24, 14})] = std::numeric_limits<float>::quiet_NaN();
  ThresholdRangeTerm<2> range(image, -3, 30);
  EXPECT_EQ(evolve<2>(disc(5), {&range}).stop, LevelSetStop::not_finite);
}

TEST(LevelSetOutcome, ConstantImageLeavesTheCurveWhereItIs) {
  RegionTerm<2> regions(field_from<2>({30, 30}, {1, 1}, [](const auto&) { return 7; }));
  const auto result = evolve<2>(disc(5), {&regions});
  EXPECT_EQ(result.stop, LevelSetStop::converged);
  EXPECT_EQ(result.rms_change_pixels, 0);
}

TEST(LevelSetOutcome, CancellingEndsItAfterTheStep) {
  ConstantTerm<2> grow(1);
  int steps = 0;
  Progress progress;
  progress.on_report = [&](std::string_view, double fraction) { EXPECT_DOUBLE_EQ(fraction, ++steps / 100.0); };
  progress.is_cancelled = [&] { return steps == 3; };
  EXPECT_THROW(evolve<2>(disc(5), {&grow}, {}, progress), Cancelled);
  EXPECT_EQ(steps, 3);
}

TEST(LevelSetOutcome, NarrowResultHasTheCurveOfTheWideOneAndItsWidthBeyond) {
  const auto image = disc(9.3);
  ThresholdRangeTerm<2> range(image, 0, 30, 3);
  LevelSetOptions options;
  const auto wide = evolve<2>(disc(5), {&range}, options);
  options.band_pixels = narrow_band_pixels<2>;
  const auto narrow = evolve<2>(disc(5), {&range}, options);
  EXPECT_EQ(narrow.steps, wide.steps);
  for (std::size_t node = 0; node < image.values.size(); ++node) {
    EXPECT_EQ(narrow.phi.values[node] >= 0, wide.phi.values[node] >= 0);
    // Distances the evolution keeps are corrected where they are off by a tenth of a pixel.
    EXPECT_NEAR(narrow.phi.values[node], std::clamp(wide.phi.values[node], -2.0f, 2.0f), 0.1);
  }
}

TEST(LevelSetOutcome, OneAndSeveralThreadsGiveTheSame) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, 1);
  const auto image = field_from<3>({70, 70, 60}, {1, 1, 1.5}, [&](const auto& p) {
    return std::sin(p.x() / 3) + std::sin(p.y() / 4) + std::sin(p.z() / 5) + 0.3 * noise(random);
  });
  const SharedField<3> shared = image;
  const auto run = [&] {
    RegionTerm<3> regions(shared);
    CurvatureTerm<3> curvature(0.5);
    LevelSetOptions options;
    options.max_steps = 15;
    return evolve<3>(image, {&regions, &curvature}, options);
  };
  const auto parallel = run();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto serial = run();
  EXPECT_EQ(parallel.phi.values, serial.phi.values);
  EXPECT_EQ(parallel.rms_change_pixels, serial.rms_change_pixels);
}

}  // namespace
}  // namespace isostack
