#pragma once

#include <filesystem>
#include <vector>

#include "io/write_options.h"
#include "recon/geometry/contour.h"

namespace isostack {

/// Reads contours (.vtp or .json), one stack per organ. Throws InputError naming the file and the
/// slice, for instance when a curve is not closed.
std::vector<ContourStack> read_contours(const std::filesystem::path& path);

/// True when the file is one that write_contours makes: tells a .vtp of contours from one of a mesh.
/// Throws InputError naming the file when it is missing or damaged.
bool holds_contours(const std::filesystem::path& path);

/// Writes contours as .vtp (closed polylines in world mm; slice pose, organ and depth as arrays) or
/// .json (schema in docs). The file appears whole or not at all.
void write_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                    const WriteOptions& options = {});

}  // namespace isostack
