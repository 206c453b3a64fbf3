#pragma once

#include <vector>

#include "recon/geometry/color.h"

namespace isostack {

enum class ColourMap {
  sequential,  ///< dark blue over green to yellow: sizes, from none to much
  diverging    ///< blue over white to red: signed values, white at 0
};

/// Values drawn in the first and the last colour of a map; what lies beyond has the colour of the nearer end.
struct ColourRange {
  double low = 0, high = 1;
  ColourMap map = ColourMap::sequential;

  bool operator==(const ColourRange&) const = default;
};

/// The colour of a value; grey for one that is not finite.
Color colour_of(double value, const ColourRange& range);

/// For sizes: from 0 to a round number at or above the 99 % quantile. For values of both signs: diverging, the same
/// with both signs. Not finite values are left out.
ColourRange automatic_range(const std::vector<double>& values);

}  // namespace isostack
