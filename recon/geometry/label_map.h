#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/color.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// One organ of a label map: the voxels of one layer that hold its value.
struct Segment {
  std::string name;
  std::uint16_t value = 1;  ///< never 0, which is background
  std::size_t layer = 0;    ///< index into LabelMap::layers
  std::optional<Color> color = std::nullopt;
};

/// Organs as voxels. One layer is enough unless organs overlap; all layers share one grid.
/// A value that no segment names is an organ without a name.
struct LabelMap {
  std::vector<LabelVolume> layers;
  std::vector<Segment> segments;
  std::vector<std::string> warnings = {};  ///< what a user must know before trusting the map
};

/// Every organ: the map's segments, then the values that no segment names, each with its number as its name.
std::vector<Segment> all_segments(const LabelMap& map);

/// The organs of that name, else those with that number; every one for "all". Throws InputError naming `where`, the
/// map's file for instance, and listing the organs present when there is none.
std::vector<Segment> chosen_segments(const LabelMap& map, const std::string& choice, const std::string& where);

/// Adds the voxels of `mask` that are not 0 as an organ, in the first layer where it overlaps no other, or in a new
/// one. The mask lies on the map's grid; segment.layer is set here and segment.value is one that no layer holds yet.
void add_segment(LabelMap& map, const LabelVolume& mask, Segment segment);

/// The map with one layer: where organs overlap, the later layer has the voxel. `overlapping_voxels`, if given,
/// becomes the number of voxels that were in several.
LabelMap flattened(LabelMap map, std::size_t* overlapping_voxels = nullptr);

}  // namespace isostack
