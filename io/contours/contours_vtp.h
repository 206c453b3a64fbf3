#pragma once

#include <filesystem>
#include <vector>

#include "io/contours/contour_file.h"
#include "io/read_slices.h"
#include "io/write_options.h"
#include "recon/geometry/contour.h"

namespace isostack {

/// Contours as VTP: closed polylines in world mm with cell arrays "organ", "slice" and "depth", and a
/// table of organs and slices (also of slices without contours) in the field data, as docs/formats.md
/// says. Reading throws InputError naming the file and slice, for instance of an open polyline.
bool is_vtp_contours(const std::filesystem::path& path);
ContourFile read_vtp_contours(const std::filesystem::path& path, const ReadOptions& options = {});
void write_vtp_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                        const WriteOptions& options = {});

}  // namespace isostack
