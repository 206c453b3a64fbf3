#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "viewers/scene.h"
#include "viewers/window/view_session.h"

namespace isostack {

/// How the level set of one slice came to rest: its curves from the start to the end, slice coordinates.
struct EvolutionReplay {
  struct State {
    double time_mm;
    std::vector<Contour> contours;
  };
  std::size_t slice = 0;  ///< index into the scene's slices
  std::vector<State> states = {};
};

struct SeedSegmentation {
  std::vector<ContourStack> organs;
  EvolutionReplay replay;
  std::vector<std::string> remarks;  ///< what a user should look at
};

/// Organs by seeds: what is like them and connected to them, its outline then smoothed by a level set seeking the limit
/// of that range. The evolution on slice `replayed` is recorded, of the first organ found there. Throws as
/// segment_organs does, and InputError when the scene has no image.
SeedSegmentation segment_from_seeds(const Scene& scene, const std::vector<ViewSeed>& seeds, std::size_t replayed,
                                    const Progress& progress = {});

}  // namespace isostack
