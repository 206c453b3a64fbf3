#include "viewers/scene_renderer.h"

#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>

#include "viewers/annotations.h"
#include "viewers/orientation_marker.h"
#include "viewers/scene_actors.h"
#include "viewers/scene_camera.h"
#include "viewers/scene_points.h"

namespace isostack {

namespace {

void add_soft_light(vtkRenderer& renderer) {
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.8);
  lights->SetKeyLightAngle(40, -25);  // from above, to the left
  lights->SetKeyToFillRatio(2);
  lights->SetKeyToBackRatio(3.5);
  lights->SetKeyToHeadRatio(1.8);
  lights->AddLightsToRenderer(&renderer);
}

/// Darkens hollows and creases, which shows depth where the light alone does not.
void add_ambient_occlusion(const std::vector<Eigen::Vector3d>& points_mm, vtkRenderer& renderer) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points_mm) box.extend(point);
  const double diagonal_mm = box.diagonal().norm();
  renderer.UseSSAOOn();
  renderer.SetSSAORadius(0.10 * diagonal_mm);
  renderer.SetSSAOBias(0.002 * diagonal_mm);
  renderer.SetSSAOKernelSize(128);
  renderer.SSAOBlurOn();
}

}  // namespace

void show_scene(const Scene& scene, const SceneLook& look, vtkRenderWindow& window) {
  std::vector<Eigen::Vector3d> points_mm = drawn_points(scene);
  if (!look.framed_points_mm.empty()) points_mm = look.framed_points_mm;
  const Eigen::Vector3d ink = look.dark ? Eigen::Vector3d(0.9, 0.9, 0.9) : Eigen::Vector3d(0.2, 0.2, 0.2);
  const Eigen::Vector3d ground = look.dark ? Eigen::Vector3d(0.09, 0.10, 0.12) : Eigen::Vector3d(1, 1, 1);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(ground.data());
  window.AddRenderer(renderer);

  const double line_width_pixels = 0.0028 * window.GetSize()[1];
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    add_surface(scene.surfaces[i], i, look.surface_opacity, *renderer);
  for (std::size_t i = 0; i < scene.contours.size(); ++i)
    add_contours(scene.contours[i], i, line_width_pixels, *renderer);
  const GreyWindow grey = grey_window_of(scene.slices);
  for (const Slice& slice : scene.slices)
    if (slice.pixels.size() > 0) add_slice(slice, grey, *renderer);

  add_soft_light(*renderer);
  if (look.surface_opacity < 1) {
    renderer->UseDepthPeelingOn();  // see-through layers in their order, whatever that of the triangles
    renderer->SetMaximumNumberOfPeels(12);
  } else if (!scene.surfaces.empty()) {
    add_ambient_occlusion(points_mm, *renderer);
  }
  add_title(scene.title, ink, *renderer);
  if (look.marks) add_scale_bar(ink, *renderer);
  aim_camera(points_mm, look.view_from, *renderer);
  if (look.marks) add_orientation_marker(look.dark, *renderer, window);
}

}  // namespace isostack
