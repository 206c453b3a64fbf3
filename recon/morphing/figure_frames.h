#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/morphing/shape.h"
#include "recon/surface/zero_contours.h"

namespace isostack {

/// Traces the frames of a morph of figures: all in the first figure's pose, on a lattice over the box of all.
class FigureFrames {
 public:
  FigureFrames(const std::vector<KeyShape>& figures, double resolution_mm);

  /// Where the function of the slice coordinates is positive. A frame that reaches the lattice's rim is looked at on a
  /// larger one, up to as far outside the box as this is wide; there it is cut.
  ContourSlice trace(const PlaneFunction& function) const;
  /// On the lattice alone, from its nodes' values.
  ContourSlice trace(const PlaneFunction& function, const Eigen::VectorXd& node_values) const;

  const PlaneLattice& lattice() const { return lattice_; }
  const Eigen::AlignedBox2d& box_mm() const { return box_mm_; }  ///< of all figures
  const SlicePose& pose() const { return pose_; }

 private:
  ContourSlice frame(std::vector<Contour> contours) const;

  SlicePose pose_;
  Eigen::Vector2i size_pixels_;
  Eigen::AlignedBox2d box_mm_;
  PlaneLattice lattice_;
};

/// The box, wider by this share of its longest side all round.
Eigen::AlignedBox2d widened(const Eigen::AlignedBox2d& box, double share);

}  // namespace isostack
