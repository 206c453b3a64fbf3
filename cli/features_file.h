#pragma once

#include <filesystem>
#include <vector>

#include "recon/morphing/subdivision_morph.h"

namespace isostack::cli {

/// What a features file says.
struct FeaturesFile {
  std::vector<CorrespondingPoints> features;
  std::vector<EnhancedTransition> transitions;
  TimeWarp warp;
};

/// {"format": "isostack-features", "version": 1, "features": [{"from": POINT, "to": POINT, "by_way_of": [{"t": 0.5,
/// "place_mm": PLACE}], "sharp": true}], "transitions": [{"level": 1, "t": 0.5, "place_mm": PLACE, "to_mm": PLACE}],
/// "warp": [[at 1/3 of the time, 16 or 64 numbers], [at 2/3]]}; all but the first two may be missing. A POINT is
/// {"shape": 0, "vertex": 3} or {"shape": 0, "place_mm": PLACE}; a PLACE is [x, y, z], LPS mm, or of figures [x, y],
/// slice mm. Throws InputError naming the file and what is wrong in it.
FeaturesFile read_features(const std::filesystem::path& path, const std::vector<KeyShape>& shapes);

}  // namespace isostack::cli
