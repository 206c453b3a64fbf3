#pragma once

#include <cstddef>
#include <vector>

#include "recon/morphing/shape.h"

namespace isostack {

/// Into how many pieces the frames of a morph fall.
struct FrameComponents {
  std::vector<std::size_t> counts;  ///< of each frame, in order; of bodies connected surfaces, cavities' too
  std::size_t most_given = 0;       ///< of the key shape that has the most
  std::vector<std::size_t> stray;   ///< frames with more pieces than any key shape has (Pasko et al. 2004, §4.2)
};

FrameComponents frame_components(const std::vector<Shape>& frames, const std::vector<KeyShape>& key_shapes);

}  // namespace isostack
