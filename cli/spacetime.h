#pragma once

#include <vector>

#include "cli/morph_frames.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/geometry/slice_pose.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/morphing/morph.h"

namespace isostack::cli {

/// The surface that all figures between the first key shape and the last sweep (Turk & O'Brien 1999, Figure 1), t along
/// the normal of their plane in mm, open at both ends with the given figures as rims. Throws InputError when the morph
/// has no such function.
TriangleMesh spacetime_surface(const Morph& morph, const SlicePose& pose, const Progress& progress);

/// The frames of figures as slices of one stack, each as far along the normal as it is from the first in the morph's
/// extra dimensions: the sections of the surface above, and what `reconstruct` would start from.
ContourStack spacetime_slices(const std::vector<MorphFrame>& frames, const Morph& morph);

}  // namespace isostack::cli
