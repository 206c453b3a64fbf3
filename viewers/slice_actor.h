#pragma once

#include <vtkSmartPointer.h>

#include "viewers/grey_window.h"
#include "viewers/scene.h"

class vtkActor;

namespace isostack {

/// What draws one slice of a scene: its image on a rectangle. The image is made when the slice is first seen, and let
/// go when it is hidden, so that large stacks take little memory beside their pixels.
class SliceActor {
 public:
  SliceActor();

  /// Takes pixels and pose anew.
  void rebuild(const SceneSlice& item, const GreyWindow& grey);
  /// Takes opacity, visibility and grey window anew.
  void update_look(const SceneSlice& item, const GreyWindow& grey);

  vtkActor& actor() const { return *actor_; }

 private:
  vtkSmartPointer<vtkActor> actor_;
  GreyWindow shown_;
};

}  // namespace isostack
