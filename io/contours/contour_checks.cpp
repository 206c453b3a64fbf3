#include "io/contours/contour_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/geometry/errors.h"
#include "recon/geometry/self_crossing.h"

namespace isostack {

namespace {

void drop_repeated_end(Contour& contour) {
  auto& points = contour.points_mm;
  while (points.size() > 1 && points.front() == points.back()) points.pop_back();
}

void check_contour(const Contour& contour, const std::string& where) {
  if (contour.points_mm.size() < 3)
    throw InputError(where, fmt::format("a contour has {} points", contour.points_mm.size()),
                     "give closed curves of three or more points");
  const bool finite = std::all_of(contour.points_mm.begin(), contour.points_mm.end(),
                                  [](const Eigen::Vector2d& point) { return point.allFinite(); });
  if (!finite) throw InputError(where, "a contour has a coordinate that is not a number", "repair the file");
  if (const auto point = self_crossing(contour))
    throw InputError(where,
                     fmt::format("a contour crosses itself at ({:.2f}, {:.2f}) mm in the slice, so that inside and "
                                 "outside are undecided there",
                                 point->x(), point->y()),
                     "redraw it, or split it into loops that do not cross");
}

}  // namespace

std::string contour_place(const std::string& file, const std::string& slice) { return file + ", slice " + slice; }

void throw_open_contour(const std::string& file, const std::string& slice) {
  throw InputError(contour_place(file, slice), "a contour is open: its last point does not join its first",
                   "close the curve or take it out");
}

void complete_slice(ContourSlice& slice, const std::string& file) {
  const std::string where = contour_place(file, slice.name);
  slice.pose = checked_pose(slice.pose, where);
  for (Contour& contour : slice.contours) {
    drop_repeated_end(contour);
    check_contour(contour, where);
  }
  orient_by_nesting(slice.contours);
}

}  // namespace isostack
