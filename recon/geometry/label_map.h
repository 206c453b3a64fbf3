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
};

}  // namespace isostack
