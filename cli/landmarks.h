#pragma once

#include <filesystem>
#include <vector>

#include "recon/morphing/warp.h"

namespace isostack::cli {

/// Corresponding points from a JSON file: {"format": "isostack-landmarks", "version": 1, "landmarks": [{"name": "tip",
/// "from_mm": [x, y, z], "to_mm": [x, y, z]}, ...]}, world LPS mm; names are for people. Throws InputError naming the
/// file and the landmark that is wrong.
std::vector<LandmarkPair> read_landmarks(const std::filesystem::path& path);

}  // namespace isostack::cli
