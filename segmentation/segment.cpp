#include "segmentation/segment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "recon/geometry/errors.h"
#include "segmentation/components.h"
#include "segmentation/for_each_slice.h"
#include "segmentation/gaussian_filter.h"
#include "segmentation/level_set.h"
#include "segmentation/number_text.h"
#include "segmentation/speed_terms.h"
#include "segmentation/trace_contours.h"

namespace isostack {

namespace {

void require(bool holds, const char* problem, const char* remedy) {
  if (!holds) throw InputError("segmentation options", problem, remedy);
}

void check(const SliceStack& stack, const SegmentationOptions& options) {
  require(std::isfinite(options.level), "the level is not a number", "give a grey value");
  require(options.gaussian_sigma_pixels >= 0 && std::isfinite(options.gaussian_sigma_pixels),
          "the Gaussian's sigma is negative or not a number", "give pixels, 0 for no filter");
  require(options.curvature >= 0 && std::isfinite(options.curvature),
          "the curvature weight is negative or not a number", "give a weight of 0 or more");
  require(options.max_steps >= 0, "the number of level-set steps is negative", "give 0 or more");
  if (stack.slices.empty()) throw InputError(stack.name, "there is no slice to segment", "give at least one image");
  for (const Slice& slice : stack.slices) {
    if (slice.pixels.size() == 0) throw InputError(slice.name, "the image has no pixels", "leave this slice out");
    if (!slice.pixels.isFinite().all())
      throw InputError(slice.name, "some pixels are not finite numbers", "repair the image or leave this slice out");
  }
}

/// The (filtered) image above the level, positive inside.
Image<float> above_level(const Slice& slice, const SegmentationOptions& options) {
  const double sigma_mm = options.gaussian_sigma_pixels * slice.pose.spacing_mm.minCoeff();
  const Image<float> filtered = gaussian_filter_mm(slice.pixels, sigma_mm, slice.pose.spacing_mm);
  const double sign = options.brighter_inside ? 1 : -1;
  return (sign * (filtered.cast<double>() - options.level)).cast<float>();
}

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

void require_crossing(const SliceStack& stack, const SegmentationOptions& options,
                      const std::vector<Image<float>>& phi) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const auto& image : phi) {
    lowest = std::min(lowest, static_cast<double>(image.minCoeff()));
    highest = std::max(highest, static_cast<double>(image.maxCoeff()));
  }
  if (lowest < 0 && highest >= 0) return;
  const double sign = options.brighter_inside ? 1 : -1;
  double darkest = options.level + sign * lowest, brightest = options.level + sign * highest;
  if (darkest > brightest) std::swap(darkest, brightest);
  const std::string what = highest < 0 ? "no pixel is on the organ's side of" : "every pixel is on the organ's side of";
  const double suggested = options.level + sign * suggest_level(phi, lowest, highest);
  throw InputError(stack.name,
                   what + " level " + number_text(options.level) + ", the values range from " + number_text(darkest) +
                       " to " + number_text(brightest),
                   darkest < brightest ? "try level " + number_text(suggested, 4)
                                       : "the image is constant and has no organ to find");
}

/// Curvature and isosurface term together, from the threshold's signed distance.
Image<float> smoothed(const Image<float>& above, const Eigen::Vector2d& spacing_mm,
                      const SegmentationOptions& options) {
  const Field<2> image = field_of(above, spacing_mm);
  const double pixel_mm = spacing_mm.minCoeff();
  CurvatureTerm<2> curvature(options.curvature * pixel_mm);
  IsosurfaceTerm<2> isosurface(image, 0, pixel_mm);
  LevelSetOptions level_set;
  level_set.max_steps = options.max_steps;
  return image_of(evolve<2>(image, {&curvature, &isosurface}, level_set).phi);
}

Mask inside_of(const Image<float>& phi) { return (phi >= 0).cast<std::uint8_t>(); }

/// Flips the sign where the mask says so; curves that stay keep their sub-pixel place.
void impose(const Mask& inside, Image<float>& phi) {
  constexpr float never_zero = std::numeric_limits<float>::min();
  phi = (inside == inside_of(phi)).select(phi, (inside != 0).select(phi.abs(), -phi.abs().cwiseMax(never_zero)));
}

void keep_largest(const std::vector<std::size_t>& order, std::vector<Image<float>>& phi) {
  std::vector<Mask> masks;
  for (const std::size_t i : order) masks.push_back(inside_of(phi[i]));
  masks = largest_component(std::move(masks));
  for (std::size_t k = 0; k < order.size(); ++k) impose(masks[k], phi[order[k]]);
}

}  // namespace

ContourStack segment(const SliceStack& stack, const SegmentationOptions& options, const Progress& progress) {
  constexpr std::string_view stage = "segment";
  check(stack, options);
  const auto order = options.largest ? stacking_order(stack) : std::vector<std::size_t>{};
  const std::size_t count = stack.slices.size();
  std::vector<Image<float>> phi(count);
  for_each_slice(count, progress, stage, 0, 0.2,
                 [&](std::size_t i) { phi[i] = above_level(stack.slices[i], options); });
  require_crossing(stack, options, phi);
  for_each_slice(count, progress, stage, 0.2, 0.8, [&](std::size_t i) {
    if (options.curvature > 0) phi[i] = smoothed(phi[i], stack.slices[i].pose.spacing_mm, options);
    if (options.fill_holes) impose(fill_holes(inside_of(phi[i])), phi[i]);
  });
  if (options.largest) keep_largest(order, phi);

  ContourStack result{stack.name, std::vector<ContourSlice>(count)};
  for_each_slice(count, progress, stage, 0.8, 1, [&](std::size_t i) {
    const Slice& slice = stack.slices[i];
    result.slices[i] = {slice.name,
                        slice.pose,
                        {static_cast<int>(slice.pixels.cols()), static_cast<int>(slice.pixels.rows())},
                        trace_contours(phi[i], slice.pose.spacing_mm)};
  });
  return result;
}

}  // namespace isostack
