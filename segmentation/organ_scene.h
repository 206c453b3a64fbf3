#pragma once

#include <optional>
#include <string>
#include <vector>

#include "segmentation/organs.h"

namespace isostack {

/// One organ on its way: a region per plane, in the scene's order.
struct OrganRegion {
  std::string name;
  std::vector<Seed> seeds;
  std::vector<SeedPixel> seed_pixels;  ///< their `slice` counts planes
  std::optional<GreyRange> range;      ///< of the last rule, if that was one of grey values
  std::vector<Image<float>> phi;       ///< >= 0 inside

  bool is_wanted() const { return name != "-"; }
};

/// Planes in order along the normal (in the stack's order when nothing asks for neighbours), their filtered grey
/// values, and the organs.
struct OrganScene {
  const SliceStack& stack;
  std::vector<std::size_t> order;    ///< plane -> slice
  std::vector<double> positions_mm;  ///< of the planes along the normal; empty unless in order
  double plane_distance_mm = 0;      ///< in_volume only
  std::vector<Image<float>> grey;
  std::vector<OrganRegion> organs;
  std::vector<std::string> remarks;

  const Slice& slice(std::size_t plane) const { return stack.slices[order[plane]]; }
  const SlicePose& pose(std::size_t plane) const { return slice(plane).pose; }
};

/// Checks the stack, orders it, finds the seeds' pixels and applies the filters and rules.
OrganScene prepare_scene(const SliceStack& stack, const OrganOptions& options, const std::vector<StartStep>& steps,
                         const Progress& progress);

/// Seeds moved to the nearest pixel of the region within 3 pixels, since noise may have taken theirs. Throws InputError
/// when there is none.
std::vector<SeedPixel> seeds_within(const OrganRegion& organ, const OrganScene& scene);

}  // namespace isostack
