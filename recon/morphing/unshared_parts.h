#pragma once

#include <cstddef>
#include <vector>

#include "segmentation/field.h"

namespace isostack {

/// A connected part of the target, or of what lies around and within it, where the start is all on the other side. No
/// curve comes there: an evolution does not fill such a part, and does not open such a hollow.
struct UnsharedRegion {
  bool is_inside = true;    ///< a part of the target; else a hollow of it
  std::size_t deepest = 0;  ///< node farthest from the target's boundary
  double depth_mm = 0;      ///< of that node
  std::vector<std::size_t> nodes;
};

/// Both are signed distances in mm, positive inside. Nodes connect along axes. Regions nowhere deeper than half a pixel
/// are left out. In the order of their first nodes.
template <int D>
std::vector<UnsharedRegion> unshared_regions(const Field<D>& start, const Field<D>& target);

extern template std::vector<UnsharedRegion> unshared_regions(const Field<2>&, const Field<2>&);
extern template std::vector<UnsharedRegion> unshared_regions(const Field<3>&, const Field<3>&);

}  // namespace isostack
