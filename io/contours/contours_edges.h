#pragma once

#include <filesystem>

#include "io/contours/contour_file.h"
#include "io/read_slices.h"
#include "io/write_options.h"

namespace isostack {

/// Cross-sections as edges with a label on either side (.contour): planes of any orientation, one organ per label;
/// neighbours share their edges. docs/formats.md has the layout. The side that a file calls left is told by its closed
/// curves: what they enclose must be larger than nothing. Throws InputError naming file and line or plane.
bool is_edge_contours(const std::filesystem::path& path);
ContourFile read_edge_contours(const std::filesystem::path& path, const ReadOptions& options = {});

/// Organs become labels 1, 2, ... in their order, 0 is outside; left is seen from where the normal A, B, C points to.
/// Names, colours, pixel sizes and the planes' axes are not kept.
void write_edge_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                         const WriteOptions& options = {});

}  // namespace isostack
