#pragma once

#include <vtkSmartPointer.h>

#include <vector>

#include "viewers/scene.h"

class vtkProp;

namespace isostack {

/// A line with ticks, and its text, for each visible mark; `height_pixels`: of the picture.
std::vector<vtkSmartPointer<vtkProp>> mark_actors(const std::vector<SceneMark>& marks, double height_pixels);

}  // namespace isostack
