#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "viewers/scene.h"

namespace isostack::testing_support {

/// Axial images of 40 × 40 mm, 4 mm apart, the middle one at z = 0: a bright ball (100) of radius 10 mm about the world
/// origin on a dark ground (0), with an edge two pixels wide and, as images have it, noise (±15, always the same).
inline std::vector<SceneSlice> ball_images(int count) {
  std::vector<SceneSlice> slices;
  std::minstd_rand random(1);
  for (int k = 0; k < count; ++k) {
    Slice image{.name = "slice " + std::to_string(k), .pose = {}, .pixels = Image<float>(40, 40)};
    image.pose.origin_mm = {-19.5, -19.5, 4.0 * (k - count / 2)};
    for (int row = 0; row < 40; ++row)
      for (int column = 0; column < 40; ++column) {
        const double depth_mm = 10 - image.pose.pixel_to_world({column, row}).norm();
        const int noise = static_cast<int>(random() % 31) - 15;
        image.pixels(row, column) = static_cast<float>(noise + 100 * std::clamp(0.5 + depth_mm / 2, 0.0, 1.0));
      }
    slices.push_back({.image = image});
  }
  return slices;
}

}  // namespace isostack::testing_support
