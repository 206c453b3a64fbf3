#pragma once

#include <vtkSmartPointer.h>

#include <cstddef>

#include "viewers/scene.h"

class vtkActor;
class vtkMapper;

namespace isostack {

/// What draws one surface of a scene.
class SurfaceActor {
 public:
  /// `index`: place in the scene, which chooses the colour of surfaces without one.
  explicit SurfaceActor(std::size_t index);

  /// Takes triangles and values anew.
  void rebuild(const SceneSurface& item);
  /// Takes style, opacity and visibility anew.
  void update_look(const SceneSurface& item);
  /// While moving, large surfaces are drawn by fewer triangles, which are made the first time.
  void set_moving(bool moving, const SceneSurface& item);

  vtkActor& actor() const { return *actor_; }

 private:
  std::size_t index_;
  vtkSmartPointer<vtkActor> actor_;
  vtkSmartPointer<vtkMapper> whole_, proxy_;
};

}  // namespace isostack
