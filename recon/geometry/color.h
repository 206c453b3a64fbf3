#pragma once

#include <cstdint>

namespace isostack {

/// Display colour of an organ, 8 bits per channel, sRGB.
struct Color {
  std::uint8_t red = 0, green = 0, blue = 0;

  bool operator==(const Color&) const = default;
};

}  // namespace isostack
