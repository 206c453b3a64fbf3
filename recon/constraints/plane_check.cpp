#include "recon/constraints/plane_check.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "recon/constraints/empty_slices.h"
#include "recon/constraints/parallel_neighbours.h"
#include "recon/constraints/plane_lines.h"
#include "recon/solvers/box_tree.h"

namespace isostack {

namespace {

/// The part of each slice to look at: what it sees near the contours.
Eigen::AlignedBox2d region_of(const ContourSlice& slice, const Eigen::AlignedBox3d& contours_box) {
  return around_contours(slice.pose, contours_box).intersection(field_of_view(slice, contours_box));
}

struct LatticePoint {
  std::size_t slice;
  Eigen::Vector2d point_in_slice_mm;
  std::optional<std::size_t> across = {};  ///< the next parallel slice, when the point lies half-way to it
};

/// The next slice along the normal, if the gap is wide enough for something to hide in it.
std::optional<std::size_t> next_across_gap(const ContourStack& stack, std::size_t s) {
  constexpr double least_gap_pixels = 2;
  const std::optional<ParallelNeighbour> next = next_along_normal(stack, s);
  if (!next || next->height_mm <= least_gap_pixels * stack.slices[s].pose.spacing_mm.minCoeff()) return {};
  return next->slice;
}

double gap_mm(const ContourStack& stack, const LatticePoint& point) {
  const ContourSlice& slice = stack.slices[point.slice];
  return slice.pose.signed_distance_mm(stack.slices[*point.across].pose.origin_mm);
}

Eigen::Vector3d position_mm(const ContourStack& stack, const LatticePoint& point) {
  const SlicePose& pose = stack.slices[point.slice].pose;
  const Eigen::Vector3d on_plane = pose.slice_to_world(point.point_in_slice_mm);
  return point.across ? on_plane + 0.5 * gap_mm(stack, point) * pose.normal() : on_plane;
}

std::vector<LatticePoint> lattice_on(const ContourStack& stack, std::size_t max_points) {
  const Eigen::AlignedBox3d box = box_of_contours(stack);
  double area_pixels = 0;
  for (const ContourSlice& slice : stack.slices) {
    const Eigen::AlignedBox2d region = region_of(slice, box);
    if (!region.isEmpty()) area_pixels += region.volume() / std::pow(slice.pose.spacing_mm.minCoeff(), 2);
  }
  const double step_pixels = std::max(2.0, std::sqrt(area_pixels / static_cast<double>(max_points)));
  std::vector<LatticePoint> lattice;
  for (std::size_t s = 0; s < stack.slices.size(); ++s) {
    const Eigen::AlignedBox2d region = region_of(stack.slices[s], box);
    if (region.isEmpty()) continue;
    const double step_mm = step_pixels * stack.slices[s].pose.spacing_mm.minCoeff();
    for (double y = region.min().y(); y <= region.max().y(); y += step_mm)
      for (double x = region.min().x(); x <= region.max().x(); x += step_mm) lattice.push_back({s, {x, y}});
    const std::optional<std::size_t> next = next_across_gap(stack, s);
    if (!next || (stack.slices[s].contours.empty() && stack.slices[*next].contours.empty())) continue;
    for (double y = region.min().y(); y <= region.max().y(); y += 2 * step_mm)
      for (double x = region.min().x(); x <= region.max().x(); x += 2 * step_mm) lattice.push_back({s, {x, y}, next});
  }
  return lattice;
}

/// What f should be half-way between two slices when it has the other sign: 0 when they do not say, which is when they
/// differ or their contours are nearer than the slices themselves.
double expected_between_mm(const ContourStack& stack, const LatticePoint& point, bool is_positive) {
  const ContourSlice &slice = stack.slices[point.slice], &across = stack.slices[*point.across];
  const Eigen::Vector2d on_across = across.pose.world_to_slice(position_mm(stack, point));
  const bool inside = is_inside(slice.contours, point.point_in_slice_mm);
  if (inside == is_positive || inside != is_inside(across.contours, on_across)) return 0;
  const double clear_mm = std::min(std::abs(signed_distance_mm(slice.contours, point.point_in_slice_mm)),
                                   std::abs(signed_distance_mm(across.contours, on_across)));
  if (clear_mm < 0.5 * gap_mm(stack, point)) return 0;
  return inside ? clear_mm : -clear_mm;
}

/// Farthest first, leaving out points nearer to a chosen one of the same slice than half that one's distance.
std::vector<Disagreement> spread_out(std::vector<Disagreement> all, std::size_t most) {
  std::sort(all.begin(), all.end(), [](const Disagreement& a, const Disagreement& b) {
    return std::abs(a.distance_mm) != std::abs(b.distance_mm) ? std::abs(a.distance_mm) > std::abs(b.distance_mm)
                                                              : a.slice < b.slice;
  });
  std::vector<Disagreement> chosen;
  for (const Disagreement& candidate : all) {
    if (chosen.size() == most) break;
    const bool covered = std::any_of(chosen.begin(), chosen.end(), [&](const Disagreement& c) {
      return c.slice == candidate.slice && (c.point_mm - candidate.point_mm).norm() < 0.5 * std::abs(c.distance_mm);
    });
    if (!covered) chosen.push_back(candidate);
  }
  return chosen;
}

/// The surface passes through every contour, also those of other planes: it is no farther than the nearest point of
/// one.
class NearestContourPoint {
 public:
  explicit NearestContourPoint(const ContourStack& stack) : tree_(in_curve_order(points_of(stack))) {
    const Eigen::MatrixXd& p = tree_.points();
    extent_mm_ = (p.rowwise().maxCoeff() - p.rowwise().minCoeff()).norm();
  }

  double distance_mm(const Eigen::Vector3d& point_mm) const {
    std::vector<BoxTree::Neighbour> found;
    for (double radius_mm = extent_mm_ / 64;; radius_mm *= 2) {
      tree_.within(point_mm, radius_mm, found, [](std::uint32_t) { return true; });
      if (!found.empty()) return std::sqrt(std::min_element(found.begin(), found.end())->squared_distance);
    }
  }

 private:
  static Eigen::MatrixXd points_of(const ContourStack& stack) {
    Eigen::MatrixXd points(3, static_cast<Eigen::Index>(point_count(stack)));
    Eigen::Index at = 0;
    for (const ContourSlice& slice : stack.slices)
      for (const Contour& contour : slice.contours)
        for (const Eigen::Vector2d& p : contour.points_mm) points.col(at++) = slice.pose.slice_to_world(p);
    return points;
  }
  static Eigen::MatrixXd in_curve_order(const Eigen::MatrixXd& points) {
    const std::vector<std::uint32_t> order = curve_order(points);
    Eigen::MatrixXd sorted(3, points.cols());
    for (std::size_t k = 0; k < order.size(); ++k) sorted.col(static_cast<Eigen::Index>(k)) = points.col(order[k]);
    return sorted;
  }

  BoxTree tree_;
  double extent_mm_ = 0;
};

}  // namespace

PlaneCheck check_planes(const std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>& values, const ContourStack& stack,
                        const PlaneCheckOptions& options) {
  const std::vector<LatticePoint> lattice = lattice_on(stack, options.max_lattice_points);
  Eigen::MatrixXd points(3, static_cast<Eigen::Index>(lattice.size()));
  for (std::size_t i = 0; i < lattice.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = position_mm(stack, lattice[i]);
  const Eigen::VectorXd f = values(points);
  const NearestContourPoint nearest(stack);

  std::vector<double> wrong_by_mm(lattice.size(), 0.0);  // 0 where the sign is right
  tbb::parallel_for(std::size_t{0}, lattice.size(), [&](std::size_t i) {
    const ContourSlice& slice = stack.slices[lattice[i].slice];
    const double value = f[static_cast<Eigen::Index>(i)];
    const auto bounded = [&](double distance_mm) {
      const double bound_mm = nearest.distance_mm(points.col(static_cast<Eigen::Index>(i)));
      return std::clamp(distance_mm, -bound_mm, bound_mm);
    };
    if (lattice[i].across) {
      const double expected_mm = expected_between_mm(stack, lattice[i], value > 0);
      if (expected_mm != 0) wrong_by_mm[i] = bounded(expected_mm);
      return;
    }
    if (is_inside(slice.contours, lattice[i].point_in_slice_mm) == (value > 0)) return;
    const double distance = slice.contours.empty() ? -half_gap_to_contours_mm(stack, slice)
                                                   : signed_distance_mm(slice.contours, lattice[i].point_in_slice_mm);
    const bool is_near =
        !slice.contours.empty() && std::abs(distance) <= options.tolerance_pixels * slice.pose.spacing_mm.minCoeff();
    if (is_near) return;
    wrong_by_mm[i] = bounded(distance);
  });

  PlaneCheck check;
  std::vector<Disagreement> all;
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const bool is_wrong = wrong_by_mm[i] != 0;
    if (is_wrong) all.push_back({lattice[i].slice, points.col(static_cast<Eigen::Index>(i)), wrong_by_mm[i]});
    ++(lattice[i].across ? check.points_between : check.points);
    (lattice[i].across ? check.wrong_between : check.wrong) += is_wrong ? 1 : 0;
  }
  check.worst = spread_out(std::move(all), options.max_new_constraints);
  return check;
}

}  // namespace isostack
