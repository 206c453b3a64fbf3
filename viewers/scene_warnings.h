#pragma once

#include <string>
#include <vector>

#include "viewers/scene.h"

namespace isostack {

/// What makes a scene look wrong, a sentence each: a surface in metres, or in RAS axes, told by its size and place
/// beside the contours and slices (alone: by its size), or one that lies elsewhere.
std::vector<std::string> scene_warnings(const Scene& scene);

}  // namespace isostack
