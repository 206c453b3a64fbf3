#pragma once

#include <Eigen/Core>
#include <vector>

#include "viewers/scene_look.h"

class vtkRenderer;

namespace isostack {

/// Looks at the points (world LPS mm) as the look says, in parallel projection, so that they fill the renderer's
/// viewport. Parallel, because only then one scale bar holds for the whole picture. `free_share`: the part of the
/// width, from the left, that they may take.
void aim_camera(const std::vector<Eigen::Vector3d>& points_mm, const SceneLook& look, double free_share,
                vtkRenderer& renderer);

}  // namespace isostack
