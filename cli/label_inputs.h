#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/input_options.h"
#include "cli/session.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/label_map.h"

namespace isostack::cli {

/// True for files that hold named organs, so that `all` goes without saying: DICOM SEG and .seg.nrrd.
bool holds_named_organs(const std::filesystem::path& path);

/// Contours of the organs that --label asks for (all where it is not given), traced in the label inputs as one scene;
/// inputs' organs of one name are one organ. Notes the readers' warnings, and organs that no chosen slice shows.
std::vector<ContourStack> organs_in_labels(const InputOptions& options, Session& session);

}  // namespace isostack::cli
