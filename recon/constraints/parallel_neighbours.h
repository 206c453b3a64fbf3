#pragma once

#include <cstddef>
#include <optional>

#include "recon/geometry/contour.h"

namespace isostack {

struct ParallelNeighbour {
  std::size_t slice;
  double height_mm;  ///< along the first slice's normal, positive
};

/// The nearest slice on the side of slice s's normal that is parallel to it; a micrometre away at least.
std::optional<ParallelNeighbour> next_along_normal(const ContourStack& stack, std::size_t s);

}  // namespace isostack
