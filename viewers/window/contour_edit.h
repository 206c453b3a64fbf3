#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

enum class EditKind { move_point, add_point, delete_point, drop_slice };

/// One change to the contours of one organ. Indices are those of the contours at the time of the edit; slices keep
/// theirs when one is dropped.
struct ContourEdit {
  EditKind kind = EditKind::move_point;
  std::size_t organ = 0, slice = 0;
  std::size_t contour = 0, point = 0;               ///< add_point: the new point's index, 1 to the number of points
  Eigen::Vector2d to_mm = Eigen::Vector2d::Zero();  ///< slice coordinates; of move_point and add_point
  /// move_point: neighbours nearer along the curve than this follow, by (1 + cos)/2 of their share of it. Traced
  /// contours have points closer than a pixel: moving one alone makes a spike.
  double reach_mm = 0;
};

/// What is done and undone in one go.
using EditStep = std::vector<ContourEdit>;

/// Contours with their changes, which can be undone and done again.
class ContourEdits {
 public:
  ContourEdits() = default;
  explicit ContourEdits(std::vector<ContourStack> organs);

  /// As changed; dropped slices are still there.
  const std::vector<ContourStack>& organs() const { return organs_; }
  bool is_dropped(std::size_t organ, std::size_t slice) const { return dropped_[organ][slice]; }
  /// As changed, without dropped slices: what a surface is to go through.
  std::vector<ContourStack> kept_organs() const;
  /// The steps in force, oldest first: applied to the contours as read they give organs().
  const std::vector<EditStep>& steps() const { return steps_; }
  bool can_redo() const { return !undone_.empty(); }

  /// Does a step and forgets those undone. Throws InputError when an index or number is none, GeometryError when a
  /// contour would cross itself, keep fewer than three points, or lie on a dropped slice; nothing is changed then.
  void apply(const EditStep& step);
  /// False when there is nothing to undo or to do again.
  bool undo();
  bool redo();

 private:
  struct Before {
    std::size_t organ, slice;
    ContourSlice content;
    bool dropped;
  };
  std::vector<ContourStack> organs_;
  std::vector<std::vector<bool>> dropped_;
  std::vector<EditStep> steps_, undone_;
  std::vector<std::vector<Before>> before_;  ///< of each step

  void apply_one(const ContourEdit& edit);
  void restore(const std::vector<Before>& before);
};

/// A slice's contours after one change of points. Throws as ContourEdits::apply does.
std::vector<Contour> edited(std::vector<Contour> contours, const ContourEdit& edit, const std::string& slice_name);

/// The point of the contours nearest to a place.
struct NearestPoint {
  std::size_t contour = 0, point = 0;
  double distance_mm = 0;
};
/// Nearest vertex, or, `on_edges`, nearest place on an edge, `point` being the index a new point gets there.
/// Without contours the distance is infinite.
NearestPoint nearest_point(const std::vector<Contour>& contours, const Eigen::Vector2d& place_mm, bool on_edges);

}  // namespace isostack
