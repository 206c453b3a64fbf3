#include "recon/morphing/figure_frames.h"

#include <utility>

namespace isostack {

namespace {

// Figures swell between their key shapes, seldom by more than this share of the box.
constexpr double first_margin = 0.1;
constexpr double largest_margin = 1;
constexpr double chord_deviation = 0.01;  // of the resolution

}  // namespace

Eigen::AlignedBox2d widened(const Eigen::AlignedBox2d& box, double share) {
  const Eigen::Vector2d by = Eigen::Vector2d::Constant(share * box.sizes().maxCoeff());
  return {box.min() - by, box.max() + by};
}

FigureFrames::FigureFrames(const std::vector<KeyShape>& figures, double resolution_mm)
    : pose_(common_pose(figures)),
      size_pixels_(std::get<ContourSlice>(figures.front().shape).size_pixels),
      box_mm_(box_of(figures).min().head<2>(), box_of(figures).max().head<2>()),
      lattice_(lattice_over(widened(box_mm_, first_margin), resolution_mm)) {}

ContourSlice FigureFrames::trace(const PlaneFunction& function) const {
  PlaneLattice lattice = lattice_;
  Eigen::VectorXd values = function(nodes_of(lattice));
  for (double margin = 2 * first_margin; margin <= largest_margin && is_cut(lattice, values); margin *= 2) {
    lattice = lattice_over(widened(box_mm_, margin), lattice_.spacing_mm);
    values = function(nodes_of(lattice));
  }
  return frame(zero_contours(function, lattice, values, chord_deviation * lattice.spacing_mm));
}

ContourSlice FigureFrames::trace(const PlaneFunction& function, const Eigen::VectorXd& node_values) const {
  return frame(zero_contours(function, lattice_, node_values, chord_deviation * lattice_.spacing_mm));
}

ContourSlice FigureFrames::frame(std::vector<Contour> contours) const {
  return {.name = "frame", .pose = pose_, .size_pixels = size_pixels_, .contours = std::move(contours)};
}

}  // namespace isostack
