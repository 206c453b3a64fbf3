#pragma once

#include <filesystem>
#include <vector>

#include "io/contours/contour_file.h"
#include "io/read_slices.h"
#include "io/write_options.h"
#include "recon/geometry/contour.h"

namespace isostack {

/// Reads contours, one stack per organ, by the file's extension; a DICOM structure set by its content, whatever its
/// name. Throws InputError naming the file and the slice, for instance when a curve is not closed.
ContourFile read_contour_file(const std::filesystem::path& path, const ReadOptions& options = {});

/// As read_contour_file, for callers that do not show its warnings.
std::vector<ContourStack> read_contours(const std::filesystem::path& path, const ReadOptions& options = {});

/// True when the file holds contours: tells a .vtp of contours from one of a mesh, a DICOM structure set from an
/// image. Throws InputError naming the file when it is missing or damaged.
bool holds_contours(const std::filesystem::path& path);

/// True when the file can only be meant as contours: a structure set, or a file with an extension of contours.
bool is_contour_file(const std::filesystem::path& path);

/// Writes contours in the format of the extension, such as .vtp (closed polylines in world mm; slice pose, organ and
/// depth as arrays), .json (schema in docs) or .dcm (DICOM RTSTRUCT). The file appears whole or not at all.
void write_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                    const WriteOptions& options = {});

}  // namespace isostack
