#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "recon/geometry/slice.h"

namespace isostack {

/// The pixels as a PNG file's bytes, first row at the top.
std::vector<std::byte> grey_png(const Image<std::uint8_t>& pixels);

}  // namespace isostack
