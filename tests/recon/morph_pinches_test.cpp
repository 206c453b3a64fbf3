#include <gtest/gtest.h>

#include <cmath>

#include "recon/metrics/frame_quality.h"
#include "recon/morphing/signed_distance_morph.h"
#include "recon/morphing/variational_morph.h"
#include "tests/support/figures.h"

namespace isostack {
namespace {

/// Largest curvature of the outline over the sequence, frames within 2 % of a change of topology left out.
double largest_curvature(const Morph& morph) {
  constexpr std::size_t count = 51;
  std::vector<FrameQuality> qualities;
  for (const Shape& frame : morph.frames(count)) qualities.push_back(frame_quality(frame));
  std::vector<double> changes;
  const auto time = [](double frame) { return frame / (count - 1); };
  for (std::size_t i = 1; i < count; ++i)
    if (qualities[i].components != qualities[i - 1].components || qualities[i].holes != qualities[i - 1].holes)
      changes.push_back(time(static_cast<double>(i) - 0.5));
  EXPECT_FALSE(changes.empty());
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto near_change = [&](double change) {
      return std::abs(time(static_cast<double>(i)) - change) <= 0.02 + time(0.5);
    };
    if (std::none_of(changes.begin(), changes.end(), near_change))
      largest = std::max(largest, qualities[i].largest_curvature());
  }
  return largest;
}

/// The paper's Figure 3: X to O, signed distances above, variational below.
TEST(MorphPinches, AreAtLeastThreeTimesSharperInSignedDistancesThanInTheVariationalMorph) {
  const std::vector<KeyShape> shapes = {testing_support::x_figure(), testing_support::o_figure()};
  const double baseline = largest_curvature(signed_distance_morph(shapes, {}));
  const double variational = largest_curvature(variational_morph(shapes, {}));
  RecordProperty("signed_distance_per_mm", std::to_string(baseline));
  RecordProperty("variational_per_mm", std::to_string(variational));
  EXPECT_GE(baseline, 3 * variational) << baseline << " against " << variational << " per mm";
}

}  // namespace
}  // namespace isostack
