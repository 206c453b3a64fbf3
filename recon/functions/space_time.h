#pragma once

#include <optional>

#include "recon/functions/bounded_blend.h"
#include "recon/functions/solid_function.h"

namespace isostack {

struct TimeSpan {
  double from = 0, to = 1;
};

/// k-D solid → (k+1)-D: the same at all times.
SolidFunction cylinder(SolidFunction solid);

/// time − from (later) or to − time (earlier), for solids of space-time.
SolidFunction times_from(double from_mm);
SolidFunction times_until(double to_mm);

/// The infinite slab orthogonal to time, r_intersection of both half-spaces.
SolidFunction time_slab(const TimeSpan& span_mm);

/// The (k+1)-D solid at a time, k-D.
SolidFunction cross_section(SolidFunction solid, double time_mm);

/// How a half-cylinder tapers off towards its end instead of being cut (Pasko et al. 2004, §4.1).
struct HalfCylinderSmoothing {
  BlendParameters blend;  ///< of the subtraction of the half-space
  double reach_mm = 1;    ///< of the bounding slab, before and after the end
};

/// The shapes meet in space-time: one ends where the gap begins, the other begins where it ends.
struct SpaceTimeBlend {
  TimeSpan gap_mm;   ///< between the half-cylinders' ends
  TimeSpan slab_mm;  ///< the blend's bounds; outside them cross-sections are the given solids
  BlendParameters blend;
  std::optional<HalfCylinderSmoothing> first, second;  ///< none: cut off at a plane
  SolidFunction bounds = {};  ///< of space-time; the blend stays within these and the slab. Empty: the slab
};

/// The bounded blending union of the half-cylinders of two cylinders, which may change with time (deformations)
/// themselves. Throws InputError when the slab does not cover the gap, the smoothing reaches out of the slab, or
/// parameters are out of range.
SolidFunction space_time_blend(SolidFunction first_cylinder, SolidFunction second_cylinder,
                               const SpaceTimeBlend& blend);

}  // namespace isostack
