#include "viewers/scene_view.h"

#include <vtkActor.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "viewers/annotations.h"
#include "viewers/axes_box.h"
#include "viewers/colour_bar.h"
#include "viewers/contours_actor.h"
#include "viewers/mark_actors.h"
#include "viewers/orientation_marker.h"
#include "viewers/scene_camera.h"
#include "viewers/scene_points.h"
#include "viewers/slice_actor.h"
#include "viewers/surface_actor.h"

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
void use_ambient_occlusion(const Eigen::AlignedBox3d& box_mm, vtkRenderer& renderer) {
  const double diagonal_mm = box_mm.diagonal().norm();
  renderer.UseSSAOOn();
  renderer.SetSSAORadius(0.10 * diagonal_mm);
  renderer.SetSSAOBias(0.002 * diagonal_mm);
  renderer.SetSSAOKernelSize(128);
  renderer.SSAOBlurOn();
}

bool shows_through(const Scene& scene) {
  const auto is_clear = [](const auto& item) { return item.visible && item.opacity < 1; };
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(), is_clear) ||
         std::any_of(scene.contours.begin(), scene.contours.end(), is_clear) ||
         std::any_of(scene.slices.begin(), scene.slices.end(), is_clear);
}

Eigen::AlignedBox3d box_of(const std::vector<Eigen::Vector3d>& points_mm) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points_mm) box.extend(point);
  return box;
}

}  // namespace

struct SceneView::Parts {
  Parts(const Scene& shown, const SceneLook& shown_as) : scene(shown), look(shown_as) {}

  const Scene& scene;
  SceneLook look;
  GreyWindow grey;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderer> in_front;  ///< of all else: marks
  std::vector<SurfaceActor> surfaces;
  std::vector<vtkSmartPointer<vtkActor>> contours;
  std::vector<SliceActor> slices;
  std::vector<vtkSmartPointer<vtkProp>> marks;
  std::optional<Title> title;
  std::optional<ColourBars> bars;
  bool is_moving = false;

  TextColours colours() const {
    return look.dark ? TextColours{.ink = {0.9, 0.9, 0.9}, .ground = {0.09, 0.10, 0.12}}
                     : TextColours{.ink = {0.2, 0.2, 0.2}, .ground = {1, 1, 1}};
  }
  double height_pixels() const { return renderer->GetSize()[1]; }
  double contour_width_pixels() const { return std::max(3.0, 0.0028 * height_pixels()); }

  void choose_quality() {
    const bool clear = shows_through(scene);
    const bool has_surface = std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                                         [](const SceneSurface& item) { return item.visible; });
    // See-through layers in their order, whatever that of the triangles; without a graphics card that takes seconds.
    renderer->SetUseDepthPeeling(clear && look.quality == Quality::fine);
    renderer->SetMaximumNumberOfPeels(12);
    renderer->UseSSAOOff();
    if (look.quality == Quality::fine && has_surface && !clear)
      use_ambient_occlusion(box_of(framed_points()), *renderer);
  }

  std::vector<Eigen::Vector3d> framed_points() const {
    return look.framed_points_mm.empty() ? visible_points(scene) : look.framed_points_mm;
  }
};

SceneView::SceneView(const Scene& scene, const SceneLook& look, vtkRenderWindow& window,
                     const Eigen::Vector4d& viewport)
    : parts_(std::make_unique<Parts>(scene, look)) {
  require_drawable(scene);
  vtkRenderer& renderer = *parts_->renderer;
  const TextColours colours = parts_->colours();
  renderer.SetBackground(colours.ground.data());
  renderer.SetViewport(viewport.data());
  window.AddRenderer(&renderer);
  parts_->in_front->SetViewport(viewport.data());
  parts_->in_front->SetLayer(1);
  parts_->in_front->InteractiveOff();
  parts_->in_front->SetActiveCamera(renderer.GetActiveCamera());
  window.SetNumberOfLayers(2);
  window.AddRenderer(parts_->in_front);
  parts_->grey = look.grey ? *look.grey : automatic_grey_window(scene);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) update_surface(i);
  for (std::size_t i = 0; i < scene.contours.size(); ++i) update_contours(i);
  for (std::size_t i = 0; i < scene.slices.size(); ++i) update_slice(i);
  add_soft_light(renderer);
  parts_->title.emplace(colours, renderer);
  parts_->bars.emplace(colours.ink, renderer);
  update_title();
  update_marks();
  update_looks();
  if (look.axes) add_axes_box(box_of(parts_->framed_points()), colours.ink, renderer);
  if (look.marks) add_scale_bar(colours, renderer);
  aim(look.view_from);
  if (look.marks) add_orientation_marker(look.dark, renderer, window);
}

SceneView::~SceneView() = default;

vtkRenderer& SceneView::renderer() const { return *parts_->renderer; }

GreyWindow SceneView::grey() const { return parts_->grey; }

void SceneView::set_grey(const GreyWindow& grey) {
  parts_->grey = grey;
  update_looks();
}

void SceneView::update_looks() {
  const Scene& scene = parts_->scene;
  for (std::size_t i = 0; i < parts_->surfaces.size(); ++i) parts_->surfaces[i].update_look(scene.surfaces[i]);
  for (std::size_t i = 0; i < parts_->contours.size(); ++i)
    update_contours_look(scene.contours[i], i, parts_->contour_width_pixels(), *parts_->contours[i]);
  for (std::size_t i = 0; i < parts_->slices.size(); ++i) parts_->slices[i].update_look(scene.slices[i], parts_->grey);
  if (parts_->bars) parts_->bars->update(scene.surfaces);
  parts_->choose_quality();
}

void SceneView::update_surface(std::size_t index) {
  for (std::size_t i = parts_->surfaces.size(); i <= index; ++i) {
    parts_->surfaces.emplace_back(i);
    parts_->renderer->AddActor(&parts_->surfaces.back().actor());
  }
  parts_->surfaces[index].rebuild(parts_->scene.surfaces[index]);
  if (parts_->bars) parts_->bars->update(parts_->scene.surfaces);
}

void SceneView::update_contours(std::size_t index) {
  for (std::size_t i = parts_->contours.size(); i <= index; ++i) {
    parts_->contours.push_back(vtkSmartPointer<vtkActor>::New());
    parts_->renderer->AddActor(parts_->contours.back());
  }
  rebuild_contours(parts_->scene.contours[index], *parts_->contours[index]);
  update_contours_look(parts_->scene.contours[index], index, parts_->contour_width_pixels(), *parts_->contours[index]);
}

void SceneView::update_slice(std::size_t index) {
  for (std::size_t i = parts_->slices.size(); i <= index; ++i) {
    parts_->slices.emplace_back();
    parts_->renderer->AddActor(&parts_->slices.back().actor());
  }
  parts_->slices[index].rebuild(parts_->scene.slices[index], parts_->grey);
}

void SceneView::update_marks() {
  for (const auto& actor : parts_->marks) parts_->in_front->RemoveViewProp(actor);
  parts_->marks = mark_actors(parts_->scene.marks, parts_->height_pixels());
  for (const auto& actor : parts_->marks) parts_->in_front->AddViewProp(actor);
}

void SceneView::update_title() { parts_->title->set(parts_->scene.title); }

void SceneView::set_moving(bool moving) {
  if (parts_->is_moving == moving) return;
  parts_->is_moving = moving;
  for (std::size_t i = 0; i < parts_->surfaces.size(); ++i)
    parts_->surfaces[i].set_moving(moving, parts_->scene.surfaces[i]);
}

void SceneView::aim(const Eigen::Vector3d& view_from) {
  parts_->look.view_from = view_from;
  const int* size = parts_->renderer->GetSize();
  const double taken = parts_->bars->width_in_heights() * size[1] / std::max(1, size[0]);
  SceneLook look = parts_->look;
  if (look.axes) look.filled *= 0.75;  // their numbers are outside
  aim_camera(parts_->framed_points(), look, std::clamp(1 - taken, 0.3, 1.0), *parts_->renderer);
}

vtkActor* SceneView::surface_actor(std::size_t index) const {
  return index < parts_->surfaces.size() ? &parts_->surfaces[index].actor() : nullptr;
}

vtkActor* SceneView::contours_actor(std::size_t index) const {
  return index < parts_->contours.size() ? parts_->contours[index].Get() : nullptr;
}

vtkActor* SceneView::slice_actor(std::size_t index) const {
  return index < parts_->slices.size() ? &parts_->slices[index].actor() : nullptr;
}

}  // namespace isostack
