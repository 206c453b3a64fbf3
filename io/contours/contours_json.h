#pragma once

#include <filesystem>
#include <vector>

#include "io/contours/contour_file.h"
#include "io/read_slices.h"
#include "io/write_options.h"
#include "recon/geometry/contour.h"

namespace isostack {

/// Contours as JSON; the schema is in docs/formats.md. Reading throws InputError naming the file
/// and the slice or the JSON value that is wrong.
bool is_json_contours(const std::filesystem::path& path);
ContourFile read_json_contours(const std::filesystem::path& path, const ReadOptions& options = {});
void write_json_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                         const WriteOptions& options = {});

}  // namespace isostack
