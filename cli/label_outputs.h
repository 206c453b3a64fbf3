#pragma once

#include <filesystem>

#include "cli/session.h"
#include "io/write_options.h"
#include "recon/geometry/label_map.h"

namespace isostack::cli {

/// Writes labels in the output's format. Where it cannot hold overlapping organs, the later one gets the shared
/// voxels, with a note that says how many.
void write_organ_labels(const LabelMap& labels, const std::filesystem::path& output, const WriteOptions& options,
                        Session& session);

}  // namespace isostack::cli
