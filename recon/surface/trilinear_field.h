#pragma once

#include <memory>

#include "recon/geometry/volume.h"
#include "recon/surface/scalar_field.h"

namespace isostack {

/// Values on a grid as a function of world mm: linear along each of its axes between voxel centres, outside the grid
/// its rim's value. Gradients are differences over one voxel along the world's axes. At least two voxels along every
/// axis. The volume is kept as long as the field.
ScalarField trilinear_field(std::shared_ptr<const Volume<float>> volume);

}  // namespace isostack
