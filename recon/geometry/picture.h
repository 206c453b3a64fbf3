#pragma once

#include <cstdint>
#include <vector>

namespace isostack {

/// An 8-bit RGB picture, rows from the top, pixels from the left, three bytes each.
struct Picture {
  int width_pixels = 0;
  int height_pixels = 0;
  std::vector<std::uint8_t> rgb;
};

}  // namespace isostack
