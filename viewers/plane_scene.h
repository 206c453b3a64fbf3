#pragma once

#include "viewers/scene.h"
#include "viewers/view_planes.h"

namespace isostack {

/// What of a scene lies in one plane: its image, its contours, and closed lines where visible surfaces cut it, in the
/// surfaces' colours. A cut is a hair's breadth nearer to whoever faces the slice than the contours.
Scene plane_scene(const Scene& scene, const ViewPlane& plane);

}  // namespace isostack
