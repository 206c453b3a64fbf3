#include "viewers/window/scene_panel.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "viewers/window/window_colours.h"

namespace isostack {

namespace {

constexpr double kept_beyond_mm = 0.05;

}  // namespace

ScenePanel::ScenePanel(const WindowModel& model, Which which, const SceneLook& look, vtkRenderWindow& window)
    : which_(which),
      view_(which == Which::result ? model.scene() : model.beside(), look, window),
      overlay_(view_.renderer()) {
  if (which == Which::result) seen_surfaces_ = model.surface_revisions();
}

const Scene& ScenePanel::scene_of(const WindowModel& model) const {
  return which_ == Which::result ? model.scene() : model.beside();
}

bool ScenePanel::is_new(const WindowModel& model, WindowPart part) {
  std::uint64_t& seen = seen_[static_cast<std::size_t>(part)];
  const std::uint64_t now = model.revision(part);
  return std::exchange(seen, now) != now;
}

bool ScenePanel::update_surfaces(const WindowModel& model) {
  if (which_ == Which::beside) return false;
  const std::vector<std::uint64_t>& now = model.surface_revisions();
  seen_surfaces_.resize(now.size(), 0);
  bool has_changed = false;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (std::exchange(seen_surfaces_[i], now[i]) != now[i]) {
      view_.update_surface(i);
      has_changed = true;
    }
  return has_changed;
}

bool ScenePanel::update(WindowModel& model) {
  const Scene& scene = scene_of(model);
  bool has_changed = update_surfaces(model);
  if (is_new(model, WindowPart::contours)) {
    for (std::size_t i = 0; i < scene.contours.size(); ++i) view_.update_contours(i);
    has_changed = true;
  }
  if (is_new(model, WindowPart::grey)) {
    view_.set_grey(model.grey());
    has_changed = true;
  }
  if (is_new(model, WindowPart::looks) || has_changed) {
    view_.update_looks();
    has_changed = true;
  }
  if (is_new(model, WindowPart::marks)) {
    view_.update_marks();
    draw_marks(model);
    has_changed = true;
  }
  if (has_changed) {
    clip_ = model.clip();
    clip_items();
  }
  return has_changed;
}

/// Surfaces and contours; those in the plane itself stay.
void ScenePanel::clip_items() {
  vtkNew<vtkPlane> plane;
  if (clip_) {
    const Eigen::Vector3d origin = -(clip_->offset() + kept_beyond_mm) * clip_->normal();
    plane->SetOrigin(origin.data());
    plane->SetNormal(clip_->normal().eval().data());
  }
  const auto clip = [&](vtkActor* actor) {
    if (!actor || !actor->GetMapper()) return false;
    actor->GetMapper()->RemoveAllClippingPlanes();
    if (clip_) actor->GetMapper()->AddClippingPlane(plane);
    return true;
  };
  for (std::size_t i = 0; clip(view_.surface_actor(i)); ++i) continue;
  for (std::size_t i = 0; clip(view_.contours_actor(i)); ++i) continue;
}

void ScenePanel::draw_marks(WindowModel& model) {
  overlay_.clear();
  const ViewLayers& layers = model.state().layers;
  if (layers.cut_lines && which_ == Which::result && model.shown_plane())
    for (const PlaneCut::Line& line : model.cut().lines)
      overlay_.add(
          curves_actor(model.shown_plane()->pose, line.contours, 0.7 * surface_colour(model.scene(), line.surface), 3));
  if (!layers.marks) return;
  std::vector<Eigen::Vector3d> picks, seeds, unwanted;
  for (const PointFacts& pick : model.picks()) picks.push_back(pick.point_mm);
  for (const ViewSeed& seed : model.state().seeds)
    (seed.name == unwanted_seed ? unwanted : seeds).push_back(seed.position_mm);
  overlay_.add(dots_actor(picks, pick_colour, 9));
  overlay_.add(dots_actor(seeds, seed_colour, 11));
  overlay_.add(dots_actor(unwanted, unwanted_colour, 11));
}

void ScenePanel::warm_up() {
  overlay_.add(dots_actor({camera().focal_mm}, pick_colour, 9));
  seen_[static_cast<std::size_t>(WindowPart::marks)] = 0;
}

bool ScenePanel::contains(int x, int y) const { return renderer().GetDraw() && renderer().IsInViewport(x, y); }

Ray ScenePanel::ray_at(int x, int y) const {
  vtkRenderer& renderer = view_.renderer();
  renderer.SetDisplayPoint(x, y, 0);
  renderer.DisplayToWorld();
  const double* world = renderer.GetWorldPoint();
  const double* direction = renderer.GetActiveCamera()->GetDirectionOfProjection();
  return {Eigen::Vector3d(world[0], world[1], world[2]) / world[3], {direction[0], direction[1], direction[2]}};
}

ViewCamera ScenePanel::camera() const {
  vtkCamera& camera = *renderer().GetActiveCamera();
  ViewCamera result;
  camera.GetPosition(result.position_mm.data());
  camera.GetFocalPoint(result.focal_mm.data());
  camera.GetViewUp(result.up.data());
  result.height_mm = 2 * camera.GetParallelScale();
  return result;
}

void ScenePanel::set_camera(const ViewCamera& wanted) {
  vtkCamera& camera = *renderer().GetActiveCamera();
  camera.SetPosition(wanted.position_mm.data());
  camera.SetFocalPoint(wanted.focal_mm.data());
  camera.SetViewUp(wanted.up.data());
  camera.SetParallelScale(wanted.height_mm / 2);
}

void ScenePanel::set_moving(bool moving) {
  view_.set_moving(moving);
  clip_items();
}

}  // namespace isostack
