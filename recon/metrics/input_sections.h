#pragma once

#include "recon/geometry/contour.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/metrics/slice_agreement.h"

namespace isostack {

/// The promise in numbers: cuts of the closed surface by every input plane against the contours given there, both ways,
/// within each slice's field of view. Slices without a contour count in the Dice number only.
SliceAgreement agreement_at_inputs(const TriangleMesh& surface, const ContourStack& contours);

}  // namespace isostack
