#pragma once

#include <Eigen/Geometry>

class vtkRenderer;

namespace isostack {

/// Adds the edges of a box with mm along the patient's left, posterior and superior directions.
void add_axes_box(const Eigen::AlignedBox3d& box_mm, const Eigen::Vector3d& ink, vtkRenderer& renderer);

}  // namespace isostack
