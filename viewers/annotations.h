#pragma once

#include <Eigen/Core>
#include <string>

class vtkRenderer;

namespace isostack {

/// Adds the title, centred at the top. Sizes follow the renderer's height.
void add_title(const std::string& title, const Eigen::Vector3d& colour, vtkRenderer& renderer);

/// Adds a bar of a round length in mm (1, 2 or 5 times a power of ten) at the bottom right; it follows the camera,
/// which must be in parallel projection.
void add_scale_bar(const Eigen::Vector3d& colour, vtkRenderer& renderer);

/// The longest round length that is at most `longest_mm` (> 0).
double round_length_mm(double longest_mm);

}  // namespace isostack
