#include "viewers/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace isostack {

namespace {

using Stops = std::array<std::array<double, 3>, 9>;

// Both maps grow evenly in lightness to the eye and can be told apart by colour-blind ones: nine stops of viridis (van
// der Walt & Smith 2015, CC0) and of the cool to warm map of Moreland (2009), whose middle is lightened.
constexpr Stops viridis = {{{68, 1, 84},
                            {71, 44, 122},
                            {59, 81, 139},
                            {44, 113, 142},
                            {33, 144, 141},
                            {39, 173, 129},
                            {92, 200, 99},
                            {170, 220, 50},
                            {253, 231, 37}}};
constexpr Stops cool_warm = {{{59, 76, 192},
                              {98, 130, 234},
                              {141, 176, 254},
                              {192, 212, 250},
                              {245, 245, 245},
                              {250, 205, 186},
                              {244, 152, 122},
                              {222, 96, 77},
                              {180, 4, 38}}};
constexpr Color unknown = {150, 150, 150};

/// A round number at or above: 1, 1.5, 2, 3, 5, 7.5 times a power of ten.
double rounded_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.5})
    if (step * power >= value * (1 - 1e-9)) return step * power;
  return 10 * power;
}

}  // namespace

Color colour_of(double value, const ColourRange& range) {
  if (!std::isfinite(value)) return unknown;
  const Stops& stops = range.map == ColourMap::sequential ? viridis : cool_warm;
  const double span = std::max(range.high - range.low, 1e-300);
  const double place = std::clamp((value - range.low) / span, 0.0, 1.0) * (stops.size() - 1.0);
  const std::size_t from = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double share = place - static_cast<double>(from);
  const auto channel = [&](std::size_t c) {
    return static_cast<std::uint8_t>(std::lround((1 - share) * stops[from][c] + share * stops[from + 1][c]));
  };
  return {channel(0), channel(1), channel(2)};
}

ColourRange automatic_range(const std::vector<double>& values) {
  std::vector<double> sizes;
  bool has_negative = false;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    sizes.push_back(std::abs(value));
    has_negative = has_negative || value < 0;
  }
  if (sizes.empty()) return {};
  const auto rank = sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), rank, sizes.end());
  const double most = rounded_up(std::max(*rank, 1e-6));
  return has_negative ? ColourRange{.low = -most, .high = most, .map = ColourMap::diverging}
                      : ColourRange{.low = 0, .high = most, .map = ColourMap::sequential};
}

}  // namespace isostack
