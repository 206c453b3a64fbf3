#pragma once

#include <Eigen/Geometry>

#include "recon/functions/solid_function.h"
#include "recon/functions/space_time.h"
#include "recon/morphing/blend_morph.h"

namespace isostack {

/// A solid with a box round it, in its own k coordinates.
struct BoxedSolid {
  SolidFunction solid;
  Eigen::AlignedBox3d box_mm;  ///< of figures: z = 0
  int dimension = 3;
};

/// Options with everything that was left unset filled in for these two shapes, in mm of space-time. Deformations do
/// not count. Throws InputError when spans do not fit, or some frame is empty whatever a0 is.
SpaceTimeBlend blend_between(const BoxedSolid& first, const BoxedSolid& second, double length_mm,
                             const BlendMorphOptions& options);

}  // namespace isostack
