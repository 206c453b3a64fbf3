#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "recon/constraints/constraint_set.h"
#include "recon/geometry/contour.h"

namespace isostack {

struct PlaneCheckOptions {
  double tolerance_pixels = 1;               ///< nearer to a contour a wrong sign is no disagreement
  std::size_t max_lattice_points = 200'000;  ///< over all slices; sets the lattice's step, at least two pixels
  std::size_t max_new_constraints = 1'500;
};

/// A place where f has the wrong sign on an input plane.
struct Disagreement {
  std::size_t slice;
  Eigen::Vector3d point_mm;
  /// What f should be, positive inside: the signed distance to the slice's contours, or to the nearest point of any
  /// slice's contour if that is nearer, as the surface passes there too.
  double distance_mm;
};

struct PlaneCheck {
  std::size_t points = 0;           ///< lattice points looked at
  std::size_t wrong = 0;            ///< of those, with the wrong sign
  std::size_t points_between = 0;   ///< looked at half-way between neighbouring parallel slices
  std::size_t wrong_between = 0;    ///< of those, with a sign that neither slice has within half a gap around
  std::vector<Disagreement> worst;  ///< farthest from the contour first, spread out; at most max_new_constraints
};

/// Compares the sign of f with the segmentation on a lattice in every input plane, also those
/// without the organ: cutting the surface with an input plane must give back that slice's contour,
/// nothing missing, nothing added. A plane says nothing outside its image. Half-way between parallel slices more than
/// two pixels apart f may change its sign only where a contour of either is nearer than half the gap: what both show
/// as far outside is not filled, what both show as far inside has no hole. `values` evaluates f.
PlaneCheck check_planes(const std::function<Eigen::VectorXd(const Eigen::MatrixXd&)>& values, const ContourStack& stack,
                        const PlaneCheckOptions& options = {});

}  // namespace isostack
