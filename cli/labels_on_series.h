#pragma once

#include <vector>

#include "cli/input_options.h"
#include "cli/like_options.h"
#include "recon/geometry/contour.h"

namespace isostack::cli {

/// True when the inputs are labels and --like names other planes than theirs to cut them on.
bool are_labels_for_series(const InputOptions& input, const LikeOptions& like);

/// Contours of the wanted labels on the planes of --like, or on their own where these are uneven. Notes the readers'
/// warnings.
std::vector<ContourStack> labels_on_series(const InputOptions& input, const LikeOptions& like, Session& session);

}  // namespace isostack::cli
