#pragma once

#include <cstddef>
#include <memory>

#include "viewers/scene.h"
#include "viewers/scene_look.h"

class vtkActor;
class vtkRenderer;
class vtkRenderWindow;

namespace isostack {

/// A scene in one renderer, kept up to date: windows and pictures alike are made of it. It refers to the scene, which
/// must outlive it and keep its address; after a change of the scene, one of the update functions is called, and the
/// window drawn again by whoever owns it. The texture of a slice is made when the slice is first seen.
class SceneView {
 public:
  /// Adds a renderer to the window, whose size is set; `viewport` is its part of the window (left, bottom, right, top;
  /// 0 to 1). Throws InputError when there is nothing to draw, or something that cannot be drawn.
  SceneView(const Scene& scene, const SceneLook& look, vtkRenderWindow& window,
            const Eigen::Vector4d& viewport = {0, 0, 1, 1});
  ~SceneView();
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  vtkRenderer& renderer() const;

  /// After a change of `visible`, opacity, style or window/level only: cheap.
  void update_looks();
  void set_grey(const GreyWindow& grey);
  GreyWindow grey() const;

  /// After a change of the item itself (mesh, values; contours; pixels or pose), or when one was added at the end.
  void update_surface(std::size_t index);
  void update_contours(std::size_t index);
  void update_slice(std::size_t index);
  void update_marks();
  void update_title();

  /// While the camera moves, surfaces of many triangles are drawn by fewer (made when first needed).
  void set_moving(bool moving);

  /// Looks from a direction (LPS) at all that is visible, or at look.framed_points_mm.
  void aim(const Eigen::Vector3d& view_from);

  /// What draws the item, for picking; null where there is none.
  vtkActor* surface_actor(std::size_t index) const;
  vtkActor* contours_actor(std::size_t index) const;
  vtkActor* slice_actor(std::size_t index) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isostack
