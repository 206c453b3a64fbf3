#pragma once

#include <gtest/gtest.h>

#include "recon/geometry/label_map.h"
#include "tests/io/volume_support.h"

namespace isostack::testing {

/// Three organs on oblique_grid(), two of which overlap; neither the first nor the last plane holds a voxel.
inline LabelMap overlapping_organs(const Grid& grid = oblique_grid()) {
  LabelMap map{.layers = {LabelVolume(grid), LabelVolume(grid)}, .segments = {}};
  map.layers[0].at(1, 1, 1) = map.layers[0].at(2, 1, 1) = map.layers[0].at(1, 2, 3) = 1;
  map.layers[0].at(3, 2, 2) = 2;
  map.layers[1].at(2, 1, 1) = map.layers[1].at(3, 2, 3) = 3;
  map.segments = {{.name = "liver", .value = 1, .layer = 0, .color = Color{221, 130, 101}},
                  {.name = "left: \"kidney\" <&> Grün", .value = 2, .layer = 0, .color = Color{0, 255, 3}},
                  {.name = "tumour", .value = 3, .layer = 1, .color = std::nullopt}};
  return map;
}

inline void expect_same_map(const LabelMap& read, const LabelMap& expected, double tolerance_mm) {
  ASSERT_EQ(read.layers.size(), expected.layers.size());
  for (std::size_t layer = 0; layer < read.layers.size(); ++layer) {
    expect_same_grid(read.layers[layer].grid, expected.layers[layer].grid, tolerance_mm);
    EXPECT_EQ(read.layers[layer].voxels, expected.layers[layer].voxels) << "layer " << layer;
  }
  ASSERT_EQ(read.segments.size(), expected.segments.size());
  for (std::size_t s = 0; s < read.segments.size(); ++s) {
    EXPECT_EQ(read.segments[s].name, expected.segments[s].name);
    EXPECT_EQ(read.segments[s].value, expected.segments[s].value);
    EXPECT_EQ(read.segments[s].layer, expected.segments[s].layer);
    EXPECT_EQ(read.segments[s].color, expected.segments[s].color);
  }
}

/// Every proper beginning, and every file with one bit turned, gives labels or an Error: never a crash.
inline void expect_labels_survive_damage(const std::filesystem::path& path) {
  const std::string whole = bytes_of(path);
  const auto try_reading = [&](const std::string& bytes) {
    write_bytes(path, bytes);
    try {
      const LabelMap map = read_labels(path);
      EXPECT_FALSE(map.layers.empty());
    } catch (const Error&) {
    }
  };
  const std::size_t stride = std::max<std::size_t>(1, whole.size() / 250);  // files are slow
  for (std::size_t length = 0; length < whole.size(); length += stride) try_reading(whole.substr(0, length));
  for (std::size_t at = 0; at < whole.size(); at += stride) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    try_reading(damaged);
  }
  write_bytes(path, whole);
}

}  // namespace isostack::testing
