#include "cli/labels_on_series.h"

#include <algorithm>

#include "cli/label_inputs.h"
#include "io/dicom/series_planes.h"
#include "io/volumes/volume_files.h"
#include "segmentation/label_sections.h"

namespace isostack::cli {

bool are_labels_for_series(const InputOptions& input, const LikeOptions& like) {
  if (like.series.empty() || !input.level.empty() || input.organ.has_rule()) return false;
  const bool names_labels =
      !input.label.empty() || std::all_of(input.paths.begin(), input.paths.end(), holds_named_organs);
  return names_labels && std::all_of(input.paths.begin(), input.paths.end(), may_hold_labels);
}

std::vector<ContourStack> labels_on_series(const InputOptions& input, const LikeOptions& like, Session& session) {
  const std::vector<ContourSlice> planes = series_planes(write_options_for(like, input));
  const LabelOptions tracing{.fill_holes = input.segmentation.fill_holes, .largest = input.segmentation.largest};
  std::vector<ContourStack> organs;
  for (const std::filesystem::path& path : input.paths) {
    const std::vector<LabelMap> maps = read_label_planes(path);
    if (maps.size() > 1) return organs_in_labels(input, session);  // no grid to cut; its planes are the images'
    const LabelMap& labels = maps.front();
    for (const std::string& warning : labels.warnings) session.note(warning);
    const auto segments = chosen_segments(labels, input.label.empty() ? "all" : input.label, path.string());
    auto found = label_sections(labels, segments, planes, tracing, session.progress());
    std::move(found.begin(), found.end(), std::back_inserter(organs));
  }
  return organs;
}

}  // namespace isostack::cli
