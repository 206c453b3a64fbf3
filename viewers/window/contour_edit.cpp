#include "viewers/window/contour_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/geometry/self_crossing.h"

namespace isostack {

namespace {

constexpr std::size_t fewest_points = 3;

/// Moves a point and, less the farther along the curve, its neighbours within reach on either side.
void move_point(Contour& contour, std::size_t point, const Eigen::Vector2d& to_mm, double reach_mm) {
  const std::vector<Eigen::Vector2d> before = contour.points_mm;
  const std::size_t count = before.size();
  const Eigen::Vector2d shift = to_mm - before[point];
  std::vector<double> distance(count, std::numeric_limits<double>::infinity());
  for (const std::size_t step : {std::size_t{1}, count - 1}) {
    double walked_mm = 0;
    for (std::size_t from = point, k = 1; k < count; ++k) {
      const std::size_t to = (from + step) % count;
      walked_mm += (before[to] - before[from]).norm();
      if (walked_mm >= reach_mm) break;
      distance[to] = std::min(distance[to], walked_mm);
      from = to;
    }
  }
  distance[point] = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i == point)
      contour.points_mm[i] = to_mm;
    else if (distance[i] < reach_mm)
      contour.points_mm[i] += (1 + std::cos(std::numbers::pi * distance[i] / reach_mm)) / 2 * shift;
  }
}

Contour& contour_of(std::vector<Contour>& contours, const ContourEdit& edit, const std::string& slice_name) {
  const std::size_t ends = edit.kind == EditKind::add_point ? 1 : 0;
  if (edit.contour >= contours.size() || edit.point < ends ||
      edit.point >= contours[edit.contour].points_mm.size() + ends)
    throw InputError(slice_name, fmt::format("it has no point {} on a contour {}", edit.point, edit.contour),
                     "edit the contours the session was made with");
  return contours[edit.contour];
}

}  // namespace

std::vector<Contour> edited(std::vector<Contour> contours, const ContourEdit& edit, const std::string& slice_name) {
  if (!edit.to_mm.allFinite() || !std::isfinite(edit.reach_mm))
    throw InputError(slice_name, "an edit moves a point to a place that is not finite", "leave that edit out");
  Contour& contour = contour_of(contours, edit, slice_name);
  const auto place = contour.points_mm.begin() + static_cast<std::ptrdiff_t>(edit.point);
  if (edit.kind == EditKind::move_point)
    move_point(contour, edit.point, edit.to_mm, edit.reach_mm);
  else if (edit.kind == EditKind::add_point)
    contour.points_mm.insert(place, edit.to_mm);
  else if (edit.kind == EditKind::delete_point)
    contour.points_mm.erase(place);
  if (contour.points_mm.size() < fewest_points)
    throw GeometryError(slice_name, "a contour needs three points", "drop the slice, or leave the point");
  if (self_crossing(contour))
    throw GeometryError(slice_name, "the contour would cross itself", "move the point less far");
  orient_by_nesting(contours);
  return contours;
}

ContourEdits::ContourEdits(std::vector<ContourStack> organs) : organs_(std::move(organs)) {
  for (const ContourStack& organ : organs_) dropped_.emplace_back(organ.slices.size(), false);
}

std::vector<ContourStack> ContourEdits::kept_organs() const {
  std::vector<ContourStack> kept = organs_;
  for (std::size_t organ = 0; organ < kept.size(); ++organ) {
    std::vector<ContourSlice> slices;
    for (std::size_t slice = 0; slice < kept[organ].slices.size(); ++slice)
      if (!dropped_[organ][slice]) slices.push_back(std::move(kept[organ].slices[slice]));
    kept[organ].slices = std::move(slices);
  }
  return kept;
}

void ContourEdits::apply_one(const ContourEdit& edit) {
  ContourSlice& slice = organs_[edit.organ].slices[edit.slice];
  std::vector<bool>& dropped = dropped_[edit.organ];
  if (dropped[edit.slice])
    throw GeometryError(slice.name, "the slice was dropped", "undo that before changing its contours");
  if (edit.kind == EditKind::drop_slice)
    dropped[edit.slice] = true;
  else
    slice.contours = edited(slice.contours, edit, slice.name);
}

void ContourEdits::apply(const EditStep& step) {
  std::vector<Before> before;
  try {
    for (const ContourEdit& edit : step) {
      if (edit.organ >= organs_.size() || edit.slice >= organs_[edit.organ].slices.size())
        throw InputError("edit", fmt::format("there is no slice {} of an organ {}", edit.slice, edit.organ),
                         "edit the contours the session was made with");
      before.push_back({edit.organ, edit.slice, organs_[edit.organ].slices[edit.slice],
                        static_cast<bool>(dropped_[edit.organ][edit.slice])});
      apply_one(edit);
    }
  } catch (...) {
    restore(before);
    throw;
  }
  steps_.push_back(step);
  before_.push_back(std::move(before));
  undone_.clear();
}

void ContourEdits::restore(const std::vector<Before>& before) {
  for (auto one = before.rbegin(); one != before.rend(); ++one) {
    organs_[one->organ].slices[one->slice] = one->content;
    dropped_[one->organ][one->slice] = one->dropped;
  }
}

bool ContourEdits::undo() {
  if (steps_.empty()) return false;
  restore(before_.back());
  before_.pop_back();
  undone_.push_back(std::move(steps_.back()));
  steps_.pop_back();
  return true;
}

bool ContourEdits::redo() {
  if (undone_.empty()) return false;
  std::vector<EditStep> later = std::move(undone_);
  const EditStep step = std::move(later.back());
  later.pop_back();
  apply(step);
  undone_ = std::move(later);
  return true;
}

NearestPoint nearest_point(const std::vector<Contour>& contours, const Eigen::Vector2d& place_mm, bool on_edges) {
  NearestPoint nearest{.distance_mm = std::numeric_limits<double>::infinity()};
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const std::vector<Eigen::Vector2d>& points = contours[c].points_mm;
    for (std::size_t i = 0; i < points.size(); ++i) {
      Eigen::Vector2d candidate = points[i];
      if (on_edges) {
        const Eigen::Vector2d edge = points[(i + 1) % points.size()] - points[i];
        const double share = (place_mm - points[i]).dot(edge) / std::max(edge.squaredNorm(), 1e-300);
        candidate += std::clamp(share, 0.0, 1.0) * edge;
      }
      const double distance_mm = (candidate - place_mm).norm();
      if (distance_mm < nearest.distance_mm) nearest = {c, on_edges ? i + 1 : i, distance_mm};
    }
  }
  return nearest;
}

}  // namespace isostack
