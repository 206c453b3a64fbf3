#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/geometry/slice_pose.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/morphing/morph.h"

namespace isostack {

/// The surface that all figures between the first key shape and the last sweep (Turk & O'Brien 1999, Figure 1), world
/// mm: the figures' plane lies at `pose`, t runs along its normal in mm. Open at both ends, with the given figures as
/// rims; outside out. Nothing when the method has no such function, the shapes are bodies or do not lie on a line.
std::optional<TriangleMesh> spacetime_surface(const Morph& morph, const SlicePose& pose, const Progress& progress = {});

/// The morph's figures at some places as slices of one stack, each as far along the normal from the first as it is in
/// the morph's extra dimensions: the sections of the surface above, and what `reconstruct` would start from. A method
/// that knows no distance between key shapes gets that of the variational one, half the figures' size.
/// One weights vector for each of the figures, of which there is at least one.
ContourStack spacetime_slices(const Morph& morph, const std::vector<ContourSlice>& figures,
                              const std::vector<Eigen::VectorXd>& weights);

}  // namespace isostack
