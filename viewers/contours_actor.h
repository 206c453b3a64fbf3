#pragma once

#include <cstddef>

#include "viewers/scene.h"

class vtkActor;

namespace isostack {

/// Contours as lines on the actor; `index`: place in the scene, which chooses the colour of organs without one.
void rebuild_contours(const SceneContours& item, vtkActor& actor);
/// Colour, opacity and visibility; `width_pixels`: of the lines on screen.
void update_contours_look(const SceneContours& item, std::size_t index, double width_pixels, vtkActor& actor);

}  // namespace isostack
