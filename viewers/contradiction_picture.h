#pragma once

#include <cstddef>
#include <optional>

#include "recon/constraints/crossings.h"
#include "recon/geometry/picture.h"
#include "viewers/scene.h"
#include "viewers/screenshot.h"

namespace isostack {

/// Two slices of one organ of a scene that contradict each other.
struct ContradictingPair {
  std::size_t organ = 0;  ///< index into the scene's contours
  SlicePair pair;
};

/// The pair of all organs whose longest contradiction is the longest; none where all slices agree.
std::optional<ContradictingPair> worst_pair(const Scene& scene);

/// The pair with its images and contours, in space at the left and each slice as its image is at the right. Stretches
/// on which one slice says inside and the other outside are marked, but those below a tenth of the longest, with their
/// length in mm, and the distance of the two contours where that is much less. Throws InputError as draw_picture().
Picture draw_contradiction(const Scene& scene, const ContradictingPair& worst, const ScreenshotOptions& options = {});

}  // namespace isostack
