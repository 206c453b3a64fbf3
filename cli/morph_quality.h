#pragma once

#include <filesystem>
#include <vector>

#include "cli/morph_frames.h"
#include "cli/session.h"

namespace isostack::cli {

/// Throws InputError when the plot could not be written at the end: it is not called .svg or its folder is missing.
void require_plot_name(const std::filesystem::path& plot);

/// Adds to the result, under "frames", what every frame is: parts, holes (figures) or genus (bodies), sizes and
/// the extremes of its boundary's curvature; and under "topology_changes" between which frames parts, holes or
/// handles come and go, and the largest curvature of frames between the key shapes and farther than 2 % of t from all
/// such changes. The text gets the same as a table. Writes it as curves over t to `plot` (.svg) unless that is empty.
void report_quality(const std::vector<MorphFrame>& frames, const std::filesystem::path& plot, Session& session);

}  // namespace isostack::cli
