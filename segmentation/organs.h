#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/geometry/slice.h"
#include "segmentation/evolve_region.h"
#include "segmentation/level_set.h"
#include "segmentation/seeds.h"
#include "segmentation/start_steps.h"

namespace isostack {

struct OrganOptions {
  /// Where the evolution starts, in order: filters, then a rule, then what changes the region. With seeds a rule
  /// like the seeds and a `connected` at the end are understood where they are missing.
  std::vector<StartStep> start = {};
  std::vector<Seed> seeds = {};     ///< one organ per name; none: one organ, everything the start finds
  double propagate_mm = 0;          ///< > 0: from the seeds' slices outwards, slice by slice, each from its neighbour's
                                    ///< result, which it may exceed by this distance
  bool in_volume = false;           ///< motions and evolution in 3D instead of slice by slice; needs even spacing
  EvolutionOptions evolution = {};  ///< what follows the start
  bool keep_distances = false;      ///< return the signed distances
  /// Called for every state of every slice's evolution (neither in_volume nor propagated), from several threads at
  /// once. `slice` is an index into the stack.
  std::function<void(std::size_t slice, const LevelSetState<2>&)> observer = {};
};

struct SegmentedOrgans {
  /// In the order their names first appear; all slices, also those without the organ.
  std::vector<ContourStack> organs;
  /// Per organ and slice: signed distance in mm, positive inside, exact near the contours, same pixels. Empty unless
  /// asked.
  std::vector<std::vector<Image<float>>> distances_mm;
  std::vector<std::string> remarks;  ///< what a user should look at, naming slices
};

/// Organs by seeds or rules, without overlap: where two would hold the same place, the curve between them follows
/// equal depths. A slice where the organ is absent has no contours.
/// Throws InputError or GeometryError naming the slice, seed or step, and what to try: NaN or constant pixels, seeds
/// beside the images, regions that are empty or everything, evolutions that vanish or flood.
SegmentedOrgans segment_organs(const SliceStack& stack, const OrganOptions& options, const Progress& progress = {});

}  // namespace isostack
