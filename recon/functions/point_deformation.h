#pragma once

#include <Eigen/Core>

#include "recon/functions/solid_function.h"
#include "recon/functions/space_time.h"

namespace isostack {

/// A point of a solid is moved and takes its surroundings along (Pasko et al. 2004, §4.2 and Figure 10).
struct PointDeformation {
  Eigen::VectorXd from_mm, to_mm;  ///< k coordinates
  double radius_mm = 1;            ///< what is farther from the point stays
  TimeSpan during_mm;              ///< stays at `from` before, at `to` after
};

/// The solid of space-time deformed: f(x − s(t) d w(|x − from − s(t) d| / radius), t) with d = to − from, w(ρ) = (1 −
/// ρ²)² for ρ < 1, otherwise 0, and s a smooth step from 0 to 1 during the span. Throws InputError when the points
/// differ in size, the span has no length, or the radius is less than 1.54 |d|: space would fold there.
SolidFunction deformed(SolidFunction space_time_solid, const PointDeformation& deformation);

}  // namespace isostack
