#include <fmt/format.h>

#include "io/dicom/rtstruct.h"
#include "io/inspect_parts.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

OrganSummary summarise(const ContourStack& organ) {
  OrganSummary summary;
  summary.name = organ.name;
  summary.type = organ.roi_type;
  summary.color = organ.color;
  for (const ContourSlice& slice : organ.slices) {
    summary.slice_count += slice.contours.empty() ? 0 : 1;
    summary.contour_count += slice.contours.size();
  }
  summary.point_count = point_count(organ);
  return summary;
}

}  // namespace

void summarise_structure_set(const std::filesystem::path& path, SeriesSummary& summary) {
  try {
    const ContourFile file = read_rtstruct(path);
    BoundsBuilder bounds(summary);
    for (const ContourStack& organ : file.organs) {
      summary.organs.push_back(summarise(organ));
      summary.contour_count += summary.organs.back().contour_count;
      summary.point_count += summary.organs.back().point_count;
      for (const ContourSlice& slice : organ.slices)
        for (const Contour& contour : slice.contours)
          for (const Eigen::Vector2d& point : contour.points_mm) bounds.add(slice.pose.slice_to_world(point));
    }
    summary.warnings.insert(summary.warnings.end(), file.warnings.begin(), file.warnings.end());
  } catch (const Error& error) {
    summary.warnings.push_back(fmt::format("unusable: {}", error.what()));
  }
}

}  // namespace isostack
