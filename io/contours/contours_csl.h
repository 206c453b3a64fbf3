#pragma once

#include <filesystem>

#include "io/contours/contour_file.h"
#include "io/read_slices.h"
#include "io/write_options.h"

namespace isostack {

/// Cross-sections with labelled loops (.csl): text that starts with CSLC, planes of any orientation, one organ per
/// label. docs/formats.md has the layout. Throws InputError naming file and line or plane.
bool is_csl(const std::filesystem::path& path);
ContourFile read_csl(const std::filesystem::path& path, const ReadOptions& options = {});

/// Organs become labels 1, 2, ... in their order; names, colours, pixel sizes and the planes' axes are not kept.
void write_csl(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
               const WriteOptions& options = {});

}  // namespace isostack
