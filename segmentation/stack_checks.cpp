#include "segmentation/stack_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "recon/geometry/errors.h"
#include "segmentation/number_text.h"

namespace isostack {

namespace {

/// A level between the darker and the brighter pixels: the middle of the two classes' means, repeated until
/// it rests (Ridler and Calvard 1978).
double suggest_level(const std::vector<Image<float>>& images, double lowest, double highest) {
  double level = (lowest + highest) / 2;
  for (int round = 0; round < 20; ++round) {
    std::array<double, 2> sum = {0, 0}, count = {0, 0};
    for (const auto& image : images)
      for (const float value : image.reshaped()) {
        sum[value >= level] += value;
        ++count[value >= level];
      }
    if (count[0] == 0 || count[1] == 0) break;
    level = (sum[0] / count[0] + sum[1] / count[1]) / 2;
  }
  return level;
}

std::string text_of(const GreyRange& range) {
  if (std::isinf(range.high)) return "level " + number_text(range.low);
  if (std::isinf(range.low)) return "level " + number_text(range.high);
  return "range " + number_text(range.low) + " to " + number_text(range.high);
}

}  // namespace

void require_segmentable(const SliceStack& stack) {
  if (stack.slices.empty()) throw InputError(stack.name, "there is no slice to segment", "give at least one image");
  for (const Slice& slice : stack.slices) {
    if (slice.pixels.size() == 0) throw InputError(slice.name, "the image has no pixels", "leave this slice out");
    if (!slice.pixels.isFinite().all())
      throw InputError(slice.name, "some pixels are not finite numbers", "repair the image or leave this slice out");
    const Eigen::Vector2d& spacing_mm = slice.pose.spacing_mm;
    if (!(spacing_mm.minCoeff() > 0) || !spacing_mm.allFinite())
      throw InputError(slice.name,
                       "its pixel spacing of " + number_text(spacing_mm.x()) + " x " + number_text(spacing_mm.y()) +
                           " mm is not positive",
                       "repair its header or give --spacing X,Y,Z for PNG and TIFF stacks");
  }
}

void require_crossing(const std::string& stack_name, const std::vector<Image<float>>& images, const GreyRange& range,
                      const std::vector<Image<float>>& depths) {
  bool any_inside = false, any_outside = false;
  for (const auto& depth : depths) {
    any_inside = any_inside || (depth >= 0).any();
    any_outside = any_outside || (depth < 0).any();
  }
  if (any_inside && any_outside) return;
  double darkest = std::numeric_limits<double>::infinity(), brightest = -darkest;
  for (const auto& image : images) {
    darkest = std::min(darkest, static_cast<double>(image.minCoeff()));
    brightest = std::max(brightest, static_cast<double>(image.maxCoeff()));
  }
  const std::string what = any_inside ? "every pixel is on the organ's side of" : "no pixel is on the organ's side of";
  throw InputError(
      stack_name,
      what + " " + text_of(range) + ", the values range from " + number_text(darkest) + " to " + number_text(brightest),
      darkest < brightest ? "try level " + number_text(suggest_level(images, darkest, brightest), 4)
                          : "the image is constant and has no organ to find");
}

}  // namespace isostack
