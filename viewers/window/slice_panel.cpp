#include "viewers/window/slice_panel.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "viewers/annotations.h"
#include "viewers/mark_actors.h"
#include "viewers/palette.h"
#include "viewers/window/window_colours.h"

namespace isostack {

namespace {

/// The patient's side a direction points to most.
std::string side_of(const Eigen::Vector3d& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return std::string(1, direction[axis] > 0 ? "LPS"[axis] : "RAI"[axis]);
}

}  // namespace

SlicePanel::SlicePanel(bool dark, vtkRenderWindow& window) : overlay_(*renderer_) {
  renderer_->SetBackground(
      (dark ? Eigen::Vector3d(0.05, 0.05, 0.06) : Eigen::Vector3d(0.93, 0.93, 0.94)).eval().data());
  renderer_->InteractiveOff();
  renderer_->GetActiveCamera()->ParallelProjectionOn();
  renderer_->AddActor(&image_.actor());
  window.AddRenderer(renderer_);
  add_scale_bar({side_letter_colour, Eigen::Vector3d::Zero()}, *renderer_);
  for (auto& letter : letters_) {
    letter = vtkSmartPointer<vtkTextActor>::New();
    vtkTextProperty& look = *letter->GetTextProperty();
    look.SetFontFamilyToArial();
    look.SetBold(1);
    look.SetFontSize(18);
    look.SetColor(side_letter_colour.x(), side_letter_colour.y(), side_letter_colour.z());
    look.SetJustificationToCentered();
    look.SetVerticalJustificationToCentered();
    letter->SetTextScaleModeToNone();
    renderer_->AddActor2D(letter);
  }
}

bool SlicePanel::update(WindowModel& model) {
  if (!model.shown_plane()) return false;
  const std::uint64_t slice = model.revision(WindowPart::slice), grey = model.revision(WindowPart::grey);
  if (slice == slice_revision_ && grey == grey_revision_) return false;
  slice_revision_ = slice;
  grey_revision_ = grey;
  show_plane(*model.shown_plane());
  show_image(model);
  overlay_.clear();
  draw_curves(model);
  draw_marks(model);
  place_letters();
  return true;
}

void SlicePanel::show_plane(const ViewPlane& plane) {
  const bool is_like_last = plane_ && plane_->family == plane.family && framed_mm_.isApprox(plane.extent_mm, 1e-6);
  plane_ = plane;
  framed_mm_ = plane.extent_mm;
  if (!is_like_last) fit();
  place_camera();
}

/// Taken anew only when it is another one or the grey window changed: copying pixels takes longer than all else here.
void SlicePanel::show_image(const WindowModel& model) {
  const bool is_same = image_index_ == plane_->image && grey_ == model.grey();
  if (is_same && has_image_) return;
  has_image_ = true;
  image_index_ = plane_->image;
  grey_ = model.grey();
  SceneSlice item{.image = {}, .visible = plane_->image.has_value()};
  if (plane_->image) item.image = model.scene().slices[*plane_->image].image;
  image_.rebuild(item, grey_);
}

void SlicePanel::draw_curves(WindowModel& model) {
  const ViewLayers& layers = model.state().layers;
  if (layers.cut_lines)
    for (const PlaneCut::Line& line : model.cut().lines)
      overlay_.add(curves_actor(plane_->pose, line.contours, surface_colour(model.scene(), line.surface), 3));
  for (const ViewPlane::Drawn& drawn : plane_->contours) {
    const std::vector<Contour>* contours = model.contours_on_plane(drawn);
    if (!contours || !layers.contours) continue;
    const SlicePose& pose = model.edits().organs()[drawn.organ].slices[drawn.slice].pose;
    const bool is_dropped = model.is_dropped(drawn);
    const Eigen::Vector3d colour = is_dropped ? dropped_colour : contour_colour(model.scene(), drawn.organ);
    overlay_.add(curves_actor(pose, *contours, colour, is_dropped ? 1 : 2));
    if (model.state().pointer != PointerMode::edit || drawn.organ != model.edited_organ() || is_dropped) continue;
    std::vector<Eigen::Vector3d> points;
    for (const Contour& contour : *contours)
      for (const Eigen::Vector2d& point : contour.points_mm) points.push_back(pose.slice_to_world(point));
    overlay_.add(dots_actor(points, colour, 6));
  }
  if (const auto* replayed = model.replayed_contours())
    overlay_.add(curves_actor(plane_->pose, *replayed, replay_colour, 2.5));
}

void SlicePanel::draw_marks(const WindowModel& model) {
  if (!model.state().layers.marks) return;
  const double near_mm = std::max(0.5, plane_->pose.spacing_mm.maxCoeff());
  const auto is_here = [&](const Eigen::Vector3d& p) {
    return std::abs(plane_->pose.signed_distance_mm(p)) <= near_mm;
  };
  std::vector<Eigen::Vector3d> picks, seeds, unwanted;
  for (const PointFacts& pick : model.picks())
    if (is_here(pick.point_mm)) picks.push_back(pick.point_mm);
  for (const ViewSeed& seed : model.state().seeds)
    if (is_here(seed.position_mm)) (seed.name == unwanted_seed ? unwanted : seeds).push_back(seed.position_mm);
  if (model.measuring_from() && is_here(*model.measuring_from())) picks.push_back(*model.measuring_from());
  overlay_.add(dots_actor(picks, pick_colour, 9));
  overlay_.add(dots_actor(seeds, seed_colour, 11));
  overlay_.add(dots_actor(unwanted, unwanted_colour, 11));
  std::vector<SceneMark> distances;
  for (const SceneMark& mark : model.scene().marks)
    if (is_here(mark.from_mm) && is_here(mark.to_mm)) distances.push_back(mark);
  for (const auto& actor : mark_actors(distances, renderer_->GetSize()[1])) overlay_.add(actor);
}

void SlicePanel::warm_up() {
  if (!plane_) return;
  const Eigen::Vector3d centre = plane_->pose.slice_to_world(centre_mm_);
  overlay_.add(dots_actor({centre}, pick_colour, 9));
  for (const auto& actor : mark_actors({{centre, centre + plane_->pose.x_axis, "0.0 mm"}}, renderer_->GetSize()[1]))
    overlay_.add(actor);
  slice_revision_ = 0;
}

void SlicePanel::fit() {
  if (!plane_) return;
  const int* size = renderer_->GetSize();
  const double aspect = std::max(1, size[0]) / static_cast<double>(std::max(1, size[1]));
  centre_mm_ = plane_->extent_mm.center();
  height_mm_ = 1.04 * std::max(plane_->extent_mm.sizes().y(), plane_->extent_mm.sizes().x() / aspect);
  place_camera();
}

void SlicePanel::place_camera() {
  if (!plane_) return;
  const SlicePose& pose = plane_->pose;
  vtkCamera& camera = *renderer_->GetActiveCamera();
  const Eigen::Vector3d focal = pose.slice_to_world(centre_mm_), normal = pose.normal();
  camera.SetFocalPoint(focal.data());
  camera.SetPosition((focal - 100 * normal).eval().data());
  camera.SetViewUp((-pose.y_axis).eval().data());
  camera.SetParallelScale(height_mm_ / 2);
  camera.SetClippingRange(90, 110);
}

void SlicePanel::place_letters() {
  const int* size = renderer_->GetSize();
  const SlicePose& pose = plane_->pose;
  const std::array<std::string, 4> texts = {side_of(-pose.x_axis), side_of(pose.x_axis), side_of(-pose.y_axis),
                                            side_of(pose.y_axis)};
  const std::array<Eigen::Vector2i, 4> places = {
      {{16, size[1] / 2}, {size[0] - 16, size[1] / 2}, {size[0] / 2, size[1] - 16}, {size[0] / 2, 16}}};
  for (std::size_t i = 0; i < letters_.size(); ++i) {
    letters_[i]->SetInput(texts[i].c_str());
    letters_[i]->SetPosition(places[i].x(), places[i].y());
  }
}

bool SlicePanel::contains(int x, int y) const { return plane_ && renderer_->IsInViewport(x, y); }

double SlicePanel::mm_per_pixel() const { return height_mm_ / std::max(1, renderer_->GetSize()[1]); }

Eigen::Vector2d SlicePanel::place_at(int x, int y) const {
  const int *size = renderer_->GetSize(), *origin = renderer_->GetOrigin();
  const Eigen::Vector2d from_centre(x + 0.5 - origin[0] - size[0] / 2.0, origin[1] + size[1] / 2.0 - (y + 0.5));
  return centre_mm_ + mm_per_pixel() * from_centre;
}

void SlicePanel::zoom(double factor) {
  height_mm_ = std::clamp(height_mm_ / factor, 1e-3, 1e6);
  place_camera();
}

void SlicePanel::pan(int pixels_right, int pixels_up) {
  centre_mm_ += mm_per_pixel() * Eigen::Vector2d(-pixels_right, pixels_up);
  place_camera();
}

}  // namespace isostack
