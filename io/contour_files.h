#pragma once

#include <filesystem>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// Reads contours (.vtp or .json), one stack per organ. Throws InputError naming the file and the
/// slice, for instance when a curve is not closed.
std::vector<ContourStack> read_contours(const std::filesystem::path& path);

/// Writes contours as .vtp (closed polylines in world mm; slice pose, organ and depth as arrays) or
/// .json (schema in docs). The file appears whole or not at all.
void write_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path);

}  // namespace isostack
