#include "recon/constraints/plane_check.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "recon/constraints/empty_slices.h"
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
};

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
  }
  return lattice;
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
    points.col(static_cast<Eigen::Index>(i)) =
        stack.slices[lattice[i].slice].pose.slice_to_world(lattice[i].point_in_slice_mm);
  const Eigen::VectorXd f = values(points);
  const NearestContourPoint nearest(stack);

  std::vector<double> wrong_by_mm(lattice.size(), 0.0);  // 0 where the sign is right
  tbb::parallel_for(std::size_t{0}, lattice.size(), [&](std::size_t i) {
    const ContourSlice& slice = stack.slices[lattice[i].slice];
    const double value = f[static_cast<Eigen::Index>(i)];
    if (is_inside(slice.contours, lattice[i].point_in_slice_mm) == (value > 0)) return;
    const double distance = slice.contours.empty() ? -half_gap_to_contours_mm(stack, slice)
                                                   : signed_distance_mm(slice.contours, lattice[i].point_in_slice_mm);
    const bool is_near =
        !slice.contours.empty() && std::abs(distance) <= options.tolerance_pixels * slice.pose.spacing_mm.minCoeff();
    if (is_near) return;
    const double bound = nearest.distance_mm(points.col(static_cast<Eigen::Index>(i)));
    wrong_by_mm[i] = std::clamp(distance, -bound, bound);
  });

  PlaneCheck check;
  check.points = lattice.size();
  std::vector<Disagreement> all;
  for (std::size_t i = 0; i < lattice.size(); ++i)
    if (wrong_by_mm[i] != 0)
      all.push_back({lattice[i].slice, points.col(static_cast<Eigen::Index>(i)), wrong_by_mm[i]});
  check.wrong = all.size();
  check.worst = spread_out(std::move(all), options.max_new_constraints);
  return check;
}

}  // namespace isostack
