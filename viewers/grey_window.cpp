#include "viewers/grey_window.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isostack {

namespace {

constexpr std::size_t most_samples = 1'000'000;

}  // namespace

GreyWindow grey_window_from(double window, double level) {
  return {static_cast<float>(level - window / 2), static_cast<float>(level + window / 2)};
}

GreyWindow automatic_grey_window(const std::vector<const Image<float>*>& images) {
  std::size_t pixels = 0;
  for (const Image<float>* image : images) pixels += static_cast<std::size_t>(image->size());
  // An odd step meets all columns of images whose width is a power of two.
  const auto step = static_cast<Eigen::Index>((pixels / most_samples) | 1U);
  std::vector<float> values;
  Eigen::Index next = 0;  // goes on from one image to the next
  for (const Image<float>* image : images) {
    for (; next < image->size(); next += step)
      if (std::isfinite(image->data()[next])) values.push_back(image->data()[next]);
    next -= image->size();
  }
  if (values.empty()) return {};
  const auto quantile = [&](double fraction) {
    const auto rank =
        values.begin() + static_cast<std::ptrdiff_t>(std::lround(fraction * static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), rank, values.end());
    return *rank;
  };
  return {quantile(0.001), quantile(0.999)};
}

Image<std::uint8_t> grey_levels(const Image<float>& pixels, const GreyWindow& window) {
  Image<std::uint8_t> grey(pixels.rows(), pixels.cols());
  const float scale = 255.F / std::max(window.high - window.low, 1e-6F);
  for (Eigen::Index i = 0; i < pixels.size(); ++i) {
    const float value = (pixels.data()[i] - window.low) * scale;
    grey.data()[i] = value > 0 ? static_cast<std::uint8_t>(std::lround(std::min(value, 255.F))) : std::uint8_t{0};
  }
  return grey;
}

}  // namespace isostack
