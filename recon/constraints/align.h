#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/constraints/crossings.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"

namespace isostack {

struct AlignOptions {
  bool rotation = false;         ///< also turn slices in their planes
  double max_shift_mm = 10;      ///< no slice moves farther
  double max_rotation_deg = 10;  ///< nor turns farther
  double robust_pixels = 0.5;    ///< mismatches beyond count linearly, not squared (Huber)
  /// Weight of staying in place, against 1 for every crossing: decides motions that the crossings leave open. Robust
  /// like them, so that one slice far off is moved rather than all others a little.
  double stay = 0.5;
  int iterations = 40;
};

/// A rigid motion within a slice's own plane: a turn about the middle of its contours, then a shift.
struct InPlaneMotion {
  Eigen::Vector2d shift_mm = Eigen::Vector2d::Zero();  ///< along the slice's x and y axes before the motion
  double rotation_rad = 0;                             ///< from x_axis towards y_axis
};

struct Alignment {
  ContourStack stack;                  ///< the slices with their poses moved; contours in slice coordinates stay
  std::vector<InPlaneMotion> motions;  ///< one per slice; none for those without contours or crossings
  int iterations = 0;
  Contradictions before, after;
};

/// The pose after the motion about `centre_mm` (slice coordinates).
SlicePose moved_in_plane(const SlicePose& pose, const InPlaneMotion& motion, const Eigen::Vector2d& centre_mm);

/// One rigid motion per slice, within its plane, that removes as much as it can of the contradictions between crossing
/// planes: breathing and motion between acquisitions. Gauss–Newton on the differences of the places where two contours
/// meet the planes' common line, measured across the contours, with a Huber loss. No image plane leaves itself, so the
/// planes' places hold the whole; motions no crossing speaks against (along a common axis, say) are the smallest.
/// Throws GeometryError as find_contradictions() does.
Alignment align_slices(const ContourStack& stack, const AlignOptions& options = {}, const Progress& progress = {});

}  // namespace isostack
