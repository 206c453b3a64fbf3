#pragma once

#include <Eigen/Core>
#include <vector>

class vtkRenderer;

namespace isostack {

/// Looks at the points (world LPS mm) from the direction `view_from`, superior up (anterior up when looking along the
/// body's axis), in parallel projection, so that all of them fill the renderer's viewport up to a margin.
/// Parallel, because only then one scale bar holds for the whole picture.
void aim_camera(const std::vector<Eigen::Vector3d>& points_mm, const Eigen::Vector3d& view_from, vtkRenderer& renderer);

}  // namespace isostack
