#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "io/contours/contour_checks.h"
#include "io/dicom/dicom_header.h"
#include "io/dicom/rtstruct.h"
#include "io/dicom/rtstruct_file.h"
#include "io/dicom/rtstruct_images.h"
#include "io/dicom/rtstruct_planes.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/simple_loops.h"

namespace isostack {

namespace {

/// "2 POINT, 1 OPEN_PLANAR": what of the ROI encloses no area.
std::string not_closed(const RtRoi& roi) {
  std::map<std::string, int> counts;
  for (const RtContour& contour : roi.contours) {
    const bool names_closed = contour.type == "CLOSED_PLANAR" || contour.type == "CLOSEDPLANAR_XOR";
    const std::string type = contour.type.empty() ? "untyped" : contour.type;
    if (!is_closed(contour)) ++counts[names_closed ? type + " of fewer than three points" : type];
  }
  std::vector<std::string> parts;
  for (const auto& [type, count] : counts) parts.push_back(fmt::format("{} {}", count, type));
  return fmt::format("{}", fmt::join(parts, ", "));
}

Contour projected(const RtContour& contour, const SlicePose& pose) {
  Contour result;
  for (const Eigen::Vector3d& point : contour.points_mm) {
    const Eigen::Vector2d place = pose.world_to_slice(point);
    if (result.points_mm.empty() || result.points_mm.back() != place) result.points_mm.push_back(place);
  }
  while (result.points_mm.size() > 1 && result.points_mm.front() == result.points_mm.back())
    result.points_mm.pop_back();
  return result;
}

/// True when both hold the same number of points in each curve: nothing was split, cut or left out.
bool same_shape(const std::vector<Contour>& a, const std::vector<Contour>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Contour& one, const Contour& other) {
    return one.points_mm.size() == other.points_mm.size();
  });
}

double usual_gap(const std::vector<double>& heights_mm) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < heights_mm.size(); ++i) gaps.push_back(heights_mm[i] - heights_mm[i - 1]);
  if (gaps.empty()) return 0;
  std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
  return gaps[gaps.size() / 2];
}

/// One organ as it is put together, over all planes of the file.
class OrganReader {
 public:
  OrganReader(const RtRoi& roi, std::size_t index, const RtPlanes& planes, bool has_images)
      : roi_(roi), planes_(planes), has_images_(has_images) {
    for (std::size_t i = 0; i < roi.contours.size(); ++i)
      if (const int plane = planes.plane_of[index][i]; plane >= 0) contours_on_[plane].push_back(i);
  }

  ContourStack read(InsideRule rule, std::vector<std::string>& warnings) {
    ContourStack organ{.name = roi_.name, .slices = {}, .color = roi_.color, .roi_type = roi_.interpreted_type};
    for (const auto& [plane, contours] : contours_on_) drawn_.emplace(plane, contours_of(plane, rule));
    std::erase_if(drawn_, [](const auto& entry) { return entry.second.empty(); });
    std::set<int> used = absent_planes();
    const std::size_t absent = used.size();
    for (const auto& [plane, contours] : drawn_) used.insert(plane);
    for (const int plane : used) {
      ContourSlice& slice = organ.slices.emplace_back(planes_.planes[static_cast<std::size_t>(plane)]);
      if (const auto drawn = drawn_.find(plane); drawn != drawn_.end()) slice.contours = drawn->second;
    }
    tell(warnings, absent);
    return organ;
  }

 private:
  std::vector<Contour> contours_of(int plane, InsideRule rule) {
    std::vector<Contour> loops;
    for (const std::size_t i : contours_on_[plane])
      loops.push_back(projected(roi_.contours[i], planes_.planes[static_cast<std::size_t>(plane)].pose));
    std::erase_if(loops, [](const Contour& contour) { return contour.points_mm.size() < 3; });
    std::vector<Contour> simple = simple_loops(loops, rule);
    if (!same_shape(loops, simple)) ++resolved_planes_;
    return simple;
  }

  /// A plane says that the organ is absent when the file or the images know it, and the organ is drawn on both sides
  /// of it farther apart than usual: contours on every third slice mean that two were skipped, not that they are
  /// empty. Beyond the ends the next image counts, and so does its size.
  std::set<int> absent_planes() const {
    std::set<int> absent;
    std::map<int, std::vector<int>> drawn_along;  // by direction, in order of height
    for (const auto& [plane, contours] : drawn_)
      drawn_along[planes_.direction_of[static_cast<std::size_t>(plane)]].push_back(plane);
    for (const auto& [direction, drawn] : drawn_along) {
      std::vector<double> heights_mm;
      for (const int plane : drawn) heights_mm.push_back(height(plane));
      const double gap_mm = usual_gap(heights_mm);
      for (std::size_t i = 1; i < drawn.size(); ++i)
        if (heights_mm[i] - heights_mm[i - 1] > 1.5 * gap_mm)
          for (int plane = drawn[i - 1] + 1; plane < drawn[i]; ++plane)
            if (is_clear_of(plane, heights_mm[i - 1], heights_mm[i], gap_mm)) absent.insert(plane);
      if (has_images_) add_ends(direction, drawn, gap_mm, absent);
    }
    return absent;
  }

  /// A contour may have been drawn next to an image rather than on it.
  bool is_clear_of(int plane, double below_mm, double above_mm, double gap_mm) const {
    return height(plane) - below_mm > 0.5 * gap_mm && above_mm - height(plane) > 0.5 * gap_mm;
  }

  void add_ends(int direction, const std::vector<int>& drawn, double gap_mm, std::set<int>& absent) const {
    for (const int step : {-1, 1}) {
      const int end = step < 0 ? drawn.front() : drawn.back();
      for (int plane = end + step; plane >= 0 && plane < static_cast<int>(planes_.planes.size()); plane += step) {
        const auto at = static_cast<std::size_t>(plane);
        if (planes_.direction_of[at] != direction) break;
        if (planes_.planes[at].size_pixels.minCoeff() <= 0) continue;
        if (std::abs(height(plane) - height(end)) < 0.75 * gap_mm) continue;
        absent.insert(plane);
        break;
      }
    }
  }

  double height(int plane) const { return planes_.height_mm[static_cast<std::size_t>(plane)]; }

  void tell(std::vector<std::string>& warnings, std::size_t absent) const {
    if (const std::string left_out = not_closed(roi_); !left_out.empty())
      warnings.push_back(fmt::format("{}: left out, for they enclose no area: {}", roi_.name, left_out));
    if (drawn_.empty()) warnings.push_back(fmt::format("{}: it has no contours", roi_.name));
    if (resolved_planes_ > 0)
      warnings.push_back(
          fmt::format("{}: contours that cross, overlap or touch on {} planes became loops that do not (keyholes: an "
                      "outer loop and a hole)",
                      roi_.name, resolved_planes_));
    if (absent > 0 && !has_images_)
      warnings.push_back(fmt::format(
          "{}: taken as absent on {} planes between its contours, on which other ROIs are drawn", roi_.name, absent));
  }

  const RtRoi& roi_;
  const RtPlanes& planes_;
  bool has_images_;
  std::map<int, std::vector<std::size_t>> contours_on_;
  std::map<int, std::vector<Contour>> drawn_;
  int resolved_planes_ = 0;
};

}  // namespace

bool is_rtstruct(const std::filesystem::path& path) {
  try {
    return std::filesystem::is_regular_file(path) && looks_like_dicom(path) &&
           read_dicom_header(path).kind == DicomKind::kStructureSet;
  } catch (const Error&) {
    return false;
  }
}

ContourFile read_rtstruct(const std::filesystem::path& path, const ReadOptions& options) {
  RtStructureSet set = read_rtstruct_file(path);
  const RtImages images = find_rt_images(path, set.series_uids, options);
  const RtPlanes planes = find_planes(set.rois, images.slices);
  ContourFile file{.organs = {}, .warnings = std::move(set.warnings)};
  file.warnings.insert(file.warnings.end(), planes.warnings.begin(), planes.warnings.end());
  const InsideRule rule = options.unite_contours ? InsideRule::any : InsideRule::odd;
  for (std::size_t i = 0; i < set.rois.size(); ++i)
    file.organs.push_back(OrganReader(set.rois[i], i, planes, !images.slices.empty()).read(rule, file.warnings));
  for (ContourStack& organ : file.organs)
    for (ContourSlice& slice : organ.slices) complete_slice(slice, path.string() + ", " + organ.name);
  if (!images.warning.empty()) file.warnings.push_back(images.warning);
  return file;
}

}  // namespace isostack
