#pragma once

#include <vector>

#include "recon/reconstruct.h"

namespace isostack {

/// The surfaces of several organs seen in the same slices, without overlap: where f_i and f_j are both positive, the
/// organ with the larger one has the place. Organ i's surface is the zero set of
///
///     min(f_i, f_i − max_{j≠i} f_j),
///
/// with f_j taken as negative beyond j's own bounds, so the surfaces of two organs share the face f_i = f_j. Organs
/// that do not overlap any other keep the surface reconstruct() gives, and so do organs whose contours were drawn
/// overlapping in a common plane, such as a tumour within an organ; options.allow_overlap keeps it for all. Throws as
/// reconstruct() does.
std::vector<Reconstruction> reconstruct_all(const std::vector<ContourStack>& organs, const ReconstructOptions& options,
                                            const Progress& progress = {});

}  // namespace isostack
