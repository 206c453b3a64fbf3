#include "io/stack_geometry.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace isostack {

namespace {

constexpr double tilt_tolerance_deg = 0.1;   // positions are written with 3 to 6 decimals
constexpr double relative_tolerance = 0.01;  // of a gap: what is still "the same distance"
constexpr double multiple_tolerance = 0.05;  // of the usual gap: how close to a whole multiple

bool same_distance(double a_mm, double b_mm) {
  return std::abs(a_mm - b_mm) <= relative_tolerance * std::max(a_mm, b_mm);
}

double tilt_deg(const SlicePose& first, const SlicePose& last) {
  const Eigen::Vector3d step_mm = last.origin_mm - first.origin_mm;
  const double along_mm = std::abs(step_mm.dot(first.normal()));
  const double across_mm = step_mm.cross(first.normal()).norm();
  return std::atan2(across_mm, along_mm) * 180 / std::numbers::pi;
}

/// A distance between slices and how often it occurs.
struct CommonGap {
  double mm = 0;
  int count = 0;
};

/// Distances in the order of their first occurrence.
std::vector<CommonGap> common_gaps(const std::vector<SliceGap>& gaps) {
  std::vector<CommonGap> common;
  for (const SliceGap& gap : gaps) {
    const auto same =
        std::find_if(common.begin(), common.end(), [&](const auto& c) { return same_distance(c.mm, gap.mm); });
    if (same == common.end())
      common.push_back({gap.mm, 1});
    else
      ++same->count;
  }
  return common;
}

/// The most frequent distance, the smaller one of equals.
double usual_gap_mm(const std::vector<CommonGap>& common) {
  return std::max_element(
             common.begin(), common.end(),
             [](const auto& a, const auto& b) { return a.count != b.count ? a.count < b.count : a.mm > b.mm; })
      ->mm;
}

std::string uneven_gaps(std::vector<CommonGap> common) {
  std::sort(common.begin(), common.end(), [](const auto& a, const auto& b) { return a.mm < b.mm; });
  std::string list;
  for (std::size_t i = 0; i < common.size() && i < 6; ++i)
    list += fmt::format("{}{} x {:.2f} mm", i == 0 ? "" : ", ", common[i].count, common[i].mm);
  if (common.size() > 6) list += fmt::format(", ... up to {:.2f} mm", common.back().mm);
  return fmt::format("uneven gaps: {}; every slice is used at its own position", list);
}

std::string missing_slices(const StackGeometry& geometry, const std::vector<std::string>& names, double usual_mm) {
  std::string list;
  for (const SliceGap& gap : geometry.gaps) {
    const double multiple = std::round(gap.mm / usual_mm);
    if (multiple < 2 || std::abs(gap.mm / usual_mm - multiple) > multiple_tolerance) continue;
    list += fmt::format("{}{:.2f} mm between {} and {} is {} times the usual {:.2f} mm", list.empty() ? "" : "; ",
                        gap.mm, names[gap.after], names[gap.after + 1], multiple, usual_mm);
  }
  return list.empty() ? list : "missing slices: suspected, " + list;
}

void add_gap_warnings(const StackGeometry& geometry, const std::vector<std::string>& names,
                      const ClaimedDistances& claimed, std::vector<std::string>& warnings) {
  const std::vector<CommonGap> common = common_gaps(geometry.gaps);
  const double usual_mm = usual_gap_mm(common);
  if (common.size() > 1) warnings.push_back(uneven_gaps(common));
  if (auto missing = missing_slices(geometry, names, usual_mm); !missing.empty())
    warnings.push_back(std::move(missing));
  const double smallest_mm =
      std::min_element(common.begin(), common.end(), [](const auto& a, const auto& b) { return a.mm < b.mm; })->mm;
  if (claimed.slice_thickness_mm && *claimed.slice_thickness_mm > smallest_mm * (1 + relative_tolerance))
    warnings.push_back(fmt::format("overlapping slices: they are {:.2f} mm thick and {:.2f} mm apart",
                                   *claimed.slice_thickness_mm, smallest_mm));
  if (claimed.spacing_between_slices_mm && !same_distance(std::abs(*claimed.spacing_between_slices_mm), usual_mm))
    warnings.push_back(
        fmt::format("differing spacing: the header says {:.2f} mm between slices, their positions {:.2f} mm; the "
                    "positions are used",
                    *claimed.spacing_between_slices_mm, usual_mm));
}

}  // namespace

StackGeometry analyse_stack(const std::vector<SlicePose>& ordered) {
  StackGeometry geometry;
  std::size_t first = 0;  // of the current direction
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    if (i == first) ++geometry.orientations;
    const bool last_of_direction = i + 1 == ordered.size() || !are_parallel(ordered[first], ordered[i + 1]);
    if (!last_of_direction) {
      const double gap_mm = (ordered[i + 1].origin_mm - ordered[i].origin_mm).dot(ordered[first].normal());
      geometry.gaps.push_back({i, gap_mm});
      continue;
    }
    if (i > first) geometry.tilt_deg = std::max(geometry.tilt_deg, tilt_deg(ordered[first], ordered[i]));
    first = i + 1;
  }
  return geometry;
}

std::vector<std::string> geometry_warnings(const StackGeometry& geometry, const std::vector<std::string>& names,
                                           const ClaimedDistances& claimed) {
  std::vector<std::string> warnings;
  if (geometry.orientations > 1)
    warnings.push_back(
        fmt::format("mixed orientations: {} slices lie in {} directions", names.size(), geometry.orientations));
  else if (geometry.tilt_deg > tilt_tolerance_deg)
    warnings.push_back(
        fmt::format("gantry tilt: the slices are stacked at {:.1f} degrees to their normal; their true "
                    "positions are used",
                    geometry.tilt_deg));
  if (!geometry.gaps.empty()) add_gap_warnings(geometry, names, claimed, warnings);
  return warnings;
}

}  // namespace isostack
