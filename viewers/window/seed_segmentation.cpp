#include "viewers/window/seed_segmentation.h"

#include <utility>

#include "recon/geometry/errors.h"
#include "segmentation/organs.h"
#include "segmentation/trace_contours.h"

namespace isostack {

namespace {

/// More would not be seen apart.
constexpr std::size_t most_states = 400;

SliceStack stack_of(const Scene& scene) {
  SliceStack stack{.name = "images", .slices = {}, .warnings = {}};
  for (const SceneSlice& slice : scene.slices) stack.slices.push_back(slice.image);
  if (stack.slices.empty())
    throw InputError("seeds", "there is no image to look for organs in", "open the images together with the surface");
  return stack;
}

}  // namespace

SeedSegmentation segment_from_seeds(const Scene& scene, const std::vector<ViewSeed>& seeds, std::size_t replayed,
                                    const Progress& progress) {
  const SliceStack stack = stack_of(scene);
  OrganOptions options;
  for (const ViewSeed& seed : seeds) options.seeds.push_back({seed.position_mm, seed.name});
  options.evolution.curvature = 1;
  SeedSegmentation result;
  result.replay.slice = replayed;
  std::vector<EvolutionReplay::State>& states = result.replay.states;
  bool is_recorded = false;  // organs evolve one after the other, and a slice in one thread
  options.observer = [&](std::size_t slice, const LevelSetState<2>& state) {
    if (slice != replayed || is_recorded) return;
    if (!states.empty() && state.time_mm <= states.back().time_mm) is_recorded = true;  // the next organ starts
    if (is_recorded || states.size() >= most_states) return;
    states.push_back({state.time_mm, trace_contours(image_of(state.phi), stack.slices[slice].pose.spacing_mm)});
  };
  SegmentedOrgans segmented = segment_organs(stack, options, progress);
  result.organs = std::move(segmented.organs);
  result.remarks = std::move(segmented.remarks);
  return result;
}

}  // namespace isostack
