// The head of the segmentation benchmarks: Debian's invesalius-examples, matrix.dat in Cranium.inv3 (segment_head.sh
// takes it out). 108 slices of 256 x 256 signed 16-bit Hounsfield units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace isostack::benchmarks {

struct HeadCt {
  static constexpr int columns = 256, rows = 256, slices = 108;
  static constexpr std::size_t slice_size = 256 * 256;
  static constexpr double spacing_mm[3] = {0.957031, 0.957031, 1.5};
  static constexpr double lower = 226, upper = 3071;  ///< bone, HU
  static constexpr double curvature = 0.5;            ///< beside a speed in HU
  static constexpr int max_steps = 100, layers = 3;

  std::vector<std::int16_t> voxels;  ///< empty when the file is not that size

  static bool is_bone(double grey) { return lower <= grey && grey <= upper; }
};

inline HeadCt read_head_ct(const std::string& path) {
  HeadCt head{std::vector<std::int16_t>(HeadCt::slice_size * HeadCt::slices)};
  std::ifstream file(path, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(head.voxels.data()), static_cast<std::streamsize>(2 * head.voxels.size())))
    head.voxels.clear();
  return head;
}

}  // namespace isostack::benchmarks
