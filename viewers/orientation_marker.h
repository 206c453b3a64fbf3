#pragma once

#include <Eigen/Core>

class vtkRenderWindow;
class vtkRenderer;

namespace isostack {

/// Adds a cube with the patient's directions (L/R, A/P, S/I) at the bottom left of `renderer`'s part of the window,
/// turning with its camera. The renderer must already be in the window.
void add_orientation_marker(bool dark, vtkRenderer& renderer, vtkRenderWindow& window);

}  // namespace isostack
