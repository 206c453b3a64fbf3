#pragma once

#include <string>
#include <vector>

#include "viewers/scene.h"

namespace isostack {

/// What a scene is of: the names, and below them the key numbers — volume of closed surfaces, triangles, contours and
/// images.
std::string title_of(const Scene& scene, const std::vector<std::string>& names);

}  // namespace isostack
