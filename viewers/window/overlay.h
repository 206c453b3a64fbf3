#pragma once

#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <vector>

#include "recon/geometry/contour.h"

class vtkActor;
class vtkProp;
class vtkRenderer;

namespace isostack {

/// Unlit lines of closed curves in one plane, world mm. Private to the window, as all of this header.
vtkSmartPointer<vtkActor> curves_actor(const SlicePose& pose, const std::vector<Contour>& contours,
                                       const Eigen::Vector3d& colour, double width_pixels);

/// Round dots, world mm.
vtkSmartPointer<vtkActor> dots_actor(const std::vector<Eigen::Vector3d>& points_mm, const Eigen::Vector3d& colour,
                                     double size_pixels);

/// Actors that are taken from a renderer and replaced together.
class Overlay {
 public:
  explicit Overlay(vtkRenderer& renderer) : renderer_(renderer) {}
  void clear();
  void add(const vtkSmartPointer<vtkProp>& actor);

 private:
  vtkRenderer& renderer_;
  std::vector<vtkSmartPointer<vtkProp>> actors_;
};

}  // namespace isostack
