#include "segmentation/threshold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isostack {

Image<float> depth_in_range(const Image<float>& image, const GreyRange& range) {
  return image.unaryExpr([&](float grey) { return static_cast<float>(range.depth(grey)); });
}

OtsuClasses otsu_classes(const std::vector<Image<float>>& images) {
  std::vector<float> values;
  for (const auto& image : images) values.insert(values.end(), image.data(), image.data() + image.size());
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return {none, none, none};
  const auto quantile = [&](double share) {
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return static_cast<double>(values[static_cast<std::size_t>(rank)]);
  };
  double low = quantile(0.001), high = quantile(0.999);
  if (!(high > low)) low = quantile(0), high = quantile(1);
  if (!(high > low)) return {none, none, none};

  constexpr int bins = 1024;
  std::array<double, bins> count{};
  for (const float value : values) {
    const double at = (value - low) / (high - low) * bins;
    ++count[static_cast<std::size_t>(std::clamp(at, 0.0, bins - 1.0))];
  }
  double total = 0, sum = 0;
  for (int bin = 0; bin < bins; ++bin) total += count[bin], sum += bin * count[bin];
  double below = 0, sum_below = 0, best = -1;
  OtsuClasses classes{none, none, none};
  const auto grey_of = [&](double bin) { return low + (high - low) * bin / bins; };
  for (int bin = 0; bin + 1 < bins; ++bin) {
    below += count[bin];
    sum_below += bin * count[bin];
    if (below == 0 || below == total) continue;
    const double dark = sum_below / below, bright = (sum - sum_below) / (total - below);
    const double between = below * (total - below) * (bright - dark) * (bright - dark);
    if (between <= best) continue;
    best = between;
    classes = {grey_of(bin + 1), grey_of(dark + 0.5), grey_of(bright + 0.5)};
  }
  return classes;
}

}  // namespace isostack
