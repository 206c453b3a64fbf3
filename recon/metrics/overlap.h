#pragma once

#include "recon/geometry/volume.h"

namespace isostack {

/// How two label volumes on one grid agree about the voxels that are not 0.
struct Overlap {
  double dice = 0;  ///< 2|A∩B| / (|A|+|B|); 1 when both are empty
  double volume_a_mm3 = 0, volume_b_mm3 = 0;
};

/// Throws InputError when the grids' sizes differ.
Overlap overlap(const LabelVolume& a, const LabelVolume& b);

}  // namespace isostack
