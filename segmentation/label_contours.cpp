#include <cmath>
#include <set>
#include <string>

#include "recon/geometry/errors.h"
#include "segmentation/components.h"
#include "segmentation/for_each_slice.h"
#include "segmentation/gaussian_filter.h"
#include "segmentation/number_text.h"
#include "segmentation/segment.h"
#include "segmentation/trace_contours.h"

namespace isostack {

namespace {

/// Wide enough to smooth the stairs of a digitised edge, narrow enough to keep what is one pixel wide.
constexpr double smoothing_pixels = 0.8;
/// How far from 0 every pixel centre stays, as a share of the step from background to label.
constexpr float least_height = 0.1f;

/// Positive on the mask, negative elsewhere, smooth across the pixel stairs.
Image<float> smooth_indicator(const Mask& mask) {
  const Image<float> height = gaussian_filter(mask.cast<float>(), Eigen::Vector2d::Constant(smoothing_pixels)) - 0.5f;
  return (mask != 0).select(height.cwiseMax(least_height), height.cwiseMin(-least_height));
}

void require_present(const SliceStack& stack, int label) {
  std::string listed;
  for (const int present : labels_in(stack)) {
    if (present == label) return;
    listed += (listed.empty() ? "" : ", ") + std::to_string(present);
  }
  throw InputError(
      stack.name, "no pixel has label " + std::to_string(label),
      listed.empty() ? "give an image with labels, this one has none" : "choose one of the labels present: " + listed);
}

std::vector<Mask> masks_of(const SliceStack& stack, int label, const LabelOptions& options) {
  std::vector<Mask> masks;
  for (const Slice& slice : stack.slices) {
    masks.emplace_back((slice.pixels == static_cast<float>(label)).cast<std::uint8_t>());
    if (options.fill_holes) masks.back() = fill_holes(masks.back());
  }
  if (!options.largest) return masks;
  const std::vector<std::size_t> order = stacking_order(stack);
  std::vector<Mask> stacked;
  for (const std::size_t i : order) stacked.push_back(std::move(masks[i]));
  stacked = largest_component(std::move(stacked));
  for (std::size_t k = 0; k < order.size(); ++k) masks[order[k]] = std::move(stacked[k]);
  return masks;
}

}  // namespace

std::vector<int> labels_in(const SliceStack& stack) {
  std::set<int> labels;
  for (const Slice& slice : stack.slices) {
    float last = 0;  // labels come in runs
    for (const float value : slice.pixels.reshaped<Eigen::RowMajor>()) {
      if (value == last) continue;
      if (!(std::abs(value) < 1e9f) || value != std::floor(value))
        throw InputError(slice.name,
                         "pixel value " + number_text(value) + " is not a whole number, so this is no label image",
                         "give a label image or a grey level");
      if (value != 0) labels.insert(static_cast<int>(value));
      last = value;
    }
  }
  return {labels.begin(), labels.end()};
}

ContourStack trace_label(const SliceStack& stack, int label, const LabelOptions& options, const Progress& progress) {
  require_present(stack, label);
  const std::vector<Mask> masks = masks_of(stack, label, options);
  const std::size_t count = stack.slices.size();
  ContourStack result{stack.name, std::vector<ContourSlice>(count)};
  for_each_slice(count, progress, "trace label", 0, 1, [&](std::size_t i) {
    const Slice& slice = stack.slices[i];
    result.slices[i] = {slice.name,
                        slice.pose,
                        {static_cast<int>(slice.pixels.cols()), static_cast<int>(slice.pixels.rows())},
                        trace_contours(smooth_indicator(masks[i]), slice.pose.spacing_mm)};
  });
  return result;
}

}  // namespace isostack
