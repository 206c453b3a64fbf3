#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "recon/constraints/constraint_set.h"
#include "recon/constraints/contour_samples.h"
#include "recon/geometry/contour.h"

namespace isostack {

/// Constraints in world mm whose values are signed distances (f > 0 inside): every sample is a
/// boundary constraint of value 0 with one partner inside and one outside, in its slice's plane.
struct ContourConstraints {
  /// A partner's distance to the contour within the plane, and the sample whose normal it shares.
  struct Partner {
    Eigen::Index constraint;
    Eigen::Index sample;
    double in_plane_distance_mm;
  };

  ConstraintSet constraints;  ///< samples first, then partners, then added points
  std::vector<ContourSample> samples;
  std::vector<Partner> partners;
};

struct ContourConstraintOptions {
  double offset_pixels = 1;  ///< distance of the partners; less where the organ or the gap is thin
};

ContourConstraints signed_constraints(const ContourStack& stack, const std::vector<ContourSample>& samples,
                                      const ContourConstraintOptions& options);

/// Where a plane cuts the surface obliquely the distance to the contour is not the distance to the
/// surface. With the unit normals n of an earlier solution (gradients at the samples, 3 × samples; smoothed_lean)
/// the partners' values become in-plane distance · |n projected onto the plane|.
/// Returns the largest change of that factor.
double correct_for_oblique_cuts(const Eigen::Matrix3Xd& gradients_at_samples, const ContourStack& stack,
                                ContourConstraints& constraints);

/// Adds points at which f shall have a given value, without partners.
void add_points(const std::vector<Eigen::Vector3d>& points_mm, const std::vector<double>& values_mm,
                ContourConstraints& constraints);

}  // namespace isostack
