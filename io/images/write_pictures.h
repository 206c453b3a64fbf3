#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "recon/geometry/picture.h"
#include "recon/geometry/slice.h"

namespace isostack {

/// Writes the picture as PNG. The file appears whole or not at all. Throws InputError naming it when it cannot be
/// written or the picture has no pixels.
void write_png(const Picture& picture, const std::filesystem::path& path);

/// The same for grey pixels, as read_slices takes them.
void write_png(const Image<std::uint8_t>& pixels, const std::filesystem::path& path);

struct GifOptions {
  double frames_per_second = 12.5;  ///< GIF counts in hundredths of a second: 100 / a whole number is kept exactly
};

/// Writes the pictures, all of one size, as an animation that starts again at its end. Colours are reduced to 256 a
/// picture. The file appears whole or not at all. Throws InputError naming it when it cannot be written, and when there
/// is no picture or their sizes differ.
void write_gif(const std::vector<Picture>& pictures, const std::filesystem::path& path, const GifOptions& options = {});

}  // namespace isostack
