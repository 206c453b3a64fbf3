#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace isostack {

/// The two colours of one organ, RGB in [0, 1].
struct OrganColours {
  Eigen::Vector3d surface;
  Eigen::Vector3d contour;
};

/// Colours of the index-th organ, repeating after eight. Surfaces follow P. Tol's "light" scheme, which colour-blind
/// eyes tell apart; each contour colour is darker than its surface and of another hue.
inline OrganColours organ_colours(std::size_t index) {
  static const std::array<OrganColours, 8> palette = {{
      {{0.53, 0.72, 0.90}, {0.83, 0.27, 0.05}},  // light blue, vermilion
      {{0.93, 0.53, 0.40}, {0.00, 0.30, 0.55}},  // orange, blue
      {{0.27, 0.73, 0.60}, {0.55, 0.10, 0.40}},  // mint, purple
      {{0.93, 0.87, 0.53}, {0.00, 0.47, 0.73}},  // yellow, blue
      {{1.00, 0.67, 0.73}, {0.00, 0.42, 0.38}},  // pink, teal
      {{0.73, 0.80, 0.20}, {0.60, 0.15, 0.10}},  // pear, dark red
      {{0.60, 0.87, 1.00}, {0.93, 0.40, 0.10}},  // cyan, orange
      {{0.80, 0.80, 0.80}, {0.93, 0.20, 0.47}},  // grey, magenta
  }};
  return palette[index % palette.size()];
}

}  // namespace isostack
