#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/morphing/distance_weights.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/shape.h"

namespace isostack {

// The two halves of a morph by signed distances: of figures and of bodies.

struct DistanceMorph {
  std::vector<KeyShape> shapes;
  DistanceWeights weights;
  double spacing_mm;  ///< a unit of the line, where t is wanted in mm
  double resolution_mm;
};

std::shared_ptr<const MorphMethod> figure_distances(DistanceMorph morph);

/// Throws SolveError when the distances need more memory than allowed.
std::shared_ptr<const MorphMethod> body_distances(DistanceMorph morph, std::size_t memory_limit_bytes,
                                                  const Progress& progress);

}  // namespace isostack
