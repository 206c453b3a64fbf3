#pragma once

#include <Eigen/Core>
#include <vector>

#include "viewers/scene.h"

class vtkRenderWindow;

namespace isostack {

struct SceneLook {
  bool dark = false;
  Eigen::Vector3d view_from = {0.5, -0.9, 0.35};       ///< direction from the scene's centre to the camera, LPS
  std::vector<Eigen::Vector3d> framed_points_mm = {};  ///< what fills the window; empty: all that is drawn
  bool marks = true;                                   ///< scale bar and cube
  double surface_opacity = 1;                          ///< 0 to 1
};

/// Fills a window, whose size is set, with the scene: lit surfaces, contours on top, textured slices, title, scale bar
/// in mm and a cube with the patient's directions. Serves pictures and interactive windows alike.
/// Throws InputError when there is nothing to draw, or something that cannot be drawn.
void show_scene(const Scene& scene, const SceneLook& look, vtkRenderWindow& window);

}  // namespace isostack
