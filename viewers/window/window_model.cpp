#include "viewers/window/window_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "recon/geometry/errors.h"
#include "viewers/camera_presets.h"
#include "viewers/palette.h"
#include "viewers/scene_title.h"

namespace isostack {

namespace {

Color surface_color(std::size_t index) {
  const auto level = [&](int channel) {
    return static_cast<std::uint8_t>(std::lround(255 * organ_colours(index).surface[channel]));
  };
  return {level(0), level(1), level(2)};
}

std::vector<ContourStack> stacks_of(const Scene& scene) {
  std::vector<ContourStack> organs;
  for (const SceneContours& contours : scene.contours) organs.push_back(contours.stack);
  return organs;
}

GreyWindow automatic_grey(const Scene& scene) {
  std::vector<const Image<float>*> images;
  for (const SceneSlice& slice : scene.slices) images.push_back(&slice.image.pixels);
  return images.empty() ? GreyWindow{} : automatic_grey_window(images);
}

}  // namespace

WindowModel::WindowModel(WindowContent content)
    : session_(std::move(content.session)),
      scene_(std::move(content.scene)),
      session_file_(std::move(content.session_file)),
      picture_file_(std::move(content.picture_file)),
      reconstruct_(content.reconstruct),
      planes_(view_planes(scene_)),
      edits_(stacks_of(scene_)),
      grey_(automatic_grey(scene_)) {
  for (std::size_t organ = 0; organ < scene_.contours.size(); ++organ)
    surface_of_organ_.push_back(scene_.surfaces.size() == scene_.contours.size() ? static_cast<int>(organ) : -1);
  beside_.surfaces = scene_surfaces(std::move(content.beside));
  std::vector<std::string> beside_names;
  for (const std::filesystem::path& path : session_.beside) beside_names.push_back(path.filename().string());
  beside_.title = title_of(beside_, beside_names);
  if (!beside_.surfaces.empty()) beside_.contours = scene_.contours;
  first_frame_ = scene_.surfaces.size();
  morph_ = Playback(content.frames.size());
  for (SceneSurface& frame : scene_surfaces(std::move(content.frames))) {
    if (!frame.mesh.color) frame.mesh.color = surface_color(first_frame_);  // one shape that changes, not many
    scene_.surfaces.push_back(std::move(frame));
  }
  surface_revisions_.assign(scene_.surfaces.size(), 1);
  take_up(ViewState(session_.state));
}

void WindowModel::take_up(const ViewState& state) {
  if (state.is_segmented)
    edits_to_redo_ = state.edits;
  else
    for (const EditStep& step : state.edits) edits_.apply(step);
  for (const Eigen::Vector3d& point : state.picks_mm) {
    const auto plane = plane_nearest_to(point, planes_);
    picks_.push_back(facts_about(point, scene_, plane ? &planes_[*plane] : nullptr));
  }
  const std::size_t last = planes_.empty() ? 0 : planes_.size() - 1;
  const bool is_new = state.plane == 0 && state.edits.empty() && !state.camera;
  session_.state.plane = is_new ? last / 2 : std::min(state.plane, last);
  morph_.show(static_cast<std::ptrdiff_t>(state.frame));
  if (planes_.empty()) session_.state.layout = WindowLayout::scene;
  contours_changed();
  session_.state.is_solved = state.is_solved;
  if (state.is_segmented)
    start_segmentation();
  else if (state.is_solved)
    start_solve();
  update_marks();
  for (std::size_t part = 0; part < revisions_.size(); ++part) changed(static_cast<WindowPart>(part));
  message_ = "? shows the keys";
}

const ViewPlane* WindowModel::shown_plane() const { return planes_.empty() ? nullptr : &planes_[session_.state.plane]; }

const std::vector<Contour>* WindowModel::contours_on_plane(const ViewPlane::Drawn& drawn) const {
  if (drag_ && drag_->drawn.organ == drawn.organ && drag_->drawn.slice == drawn.slice) return &drag_->contours;
  if (drawn.organ >= edits_.organs().size() || drawn.slice >= edits_.organs()[drawn.organ].slices.size())
    return nullptr;
  return &edits_.organs()[drawn.organ].slices[drawn.slice].contours;
}

const PlaneCut& WindowModel::cut() {
  if (!cut_) cut_ = shown_plane() ? cut_by_plane(*shown_plane(), scene_, surface_of_organ_) : PlaneCut{};
  return *cut_;
}

ClipPlane WindowModel::clip() const {
  if (session_.state.clip == ClipSide::none || !shown_plane()) return std::nullopt;
  const SlicePose& pose = shown_plane()->pose;
  const Eigen::Vector3d shown = session_.state.clip == ClipSide::front ? -pose.normal() : pose.normal();
  return Eigen::Hyperplane<double, 3>(shown, pose.origin_mm);
}

const std::vector<Contour>* WindowModel::replayed_contours() const {
  if (!shows_replay_ || !shown_plane() || shown_plane()->image != replay_.slice || replay_.states.empty())
    return nullptr;
  return &replay_.states[replay_player_.position()].contours;
}

std::optional<std::filesystem::path> WindowModel::take_picture_request() {
  if (!std::exchange(wants_picture_, false)) return std::nullopt;
  std::filesystem::path path = picture_file_;
  for (int number = 2; std::filesystem::exists(path); ++number)  // earlier pictures are kept
    path.replace_filename(fmt::format("{}-{}.png", picture_file_.stem().string(), number));
  return path;
}

std::optional<Eigen::Vector3d> WindowModel::take_camera_request() { return std::exchange(wants_camera_, std::nullopt); }

void WindowModel::say(const std::string& message) {
  message_ = message;
  changed(WindowPart::text);
}

void WindowModel::act(ViewAction action) {
  try {
    if (!act_on_view(action) && !act_on_layers(action) && !act_on_marks(action) && !act_on_edits(action))
      act_on_work(action);
  } catch (const Error& error) {
    say(error.what());
  }
  changed(WindowPart::text);
}

bool WindowModel::act_on_view(ViewAction action) {
  using enum ViewAction;
  const auto plane = static_cast<std::ptrdiff_t>(session_.state.plane);
  const auto look = [&](std::string_view preset) { wants_camera_ = camera_direction(preset); };
  switch (action) {
    case next_plane:
      show_plane(plane + 1);
      return true;
    case previous_plane:
      show_plane(plane - 1);
      return true;
    case ten_planes_on:
      show_plane(plane + 10);
      return true;
    case ten_planes_back:
      show_plane(plane - 10);
      return true;
    case first_plane:
      show_plane(0);
      return true;
    case last_plane:
      show_plane(static_cast<std::ptrdiff_t>(planes_.size()) - 1);
      return true;
    case look_anterior:
      look("anterior");
      return true;
    case look_posterior:
      look("posterior");
      return true;
    case look_left:
      look("left");
      return true;
    case look_right:
      look("right");
      return true;
    case look_superior:
      look("superior");
      return true;
    case look_inferior:
      look("inferior");
      return true;
    case look_oblique:
      look("oblique");
      return true;
    case wider_grey:
      change_grey(1.25, 0);
      return true;
    case narrower_grey:
      change_grey(0.8, 0);
      return true;
    case brighter:
      change_grey(1, -0.1);
      return true;
    case darker:
      change_grey(1, 0.1);
      return true;
    case automatic_grey:
      set_grey(grey_);
      return true;
    case help:
      wants_help_ = !wants_help_;
      changed(WindowPart::layout);
      return true;
    case quit:
      wants_to_close_ = true;
      return true;
    default:
      return false;
  }
}

void WindowModel::show_plane(std::ptrdiff_t plane) {
  if (planes_.empty()) return;
  const auto last = static_cast<std::ptrdiff_t>(planes_.size()) - 1;
  session_.state.plane = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(plane, 0, last));
  drag_.reset();
  cut_.reset();
  show_layers();
  changed(WindowPart::text);
}

void WindowModel::show_frame(std::ptrdiff_t frame) {
  if (morph_.count() == 0) return;
  morph_.show(frame);
  show_layers();
}

void WindowModel::set_grey(const GreyWindow& grey) {
  session_.state.grey = grey == grey_ ? std::nullopt : std::optional(grey);
  say(fmt::format("grey values {:g} to {:g}", grey.low, grey.high));
  changed(WindowPart::grey);
}

void WindowModel::change_grey(double width_factor, double shift_share) {
  const GreyWindow now = grey();
  const double width = static_cast<double>(now.high) - now.low, level = (static_cast<double>(now.high) + now.low) / 2;
  set_grey(grey_window_from(width * width_factor, level + shift_share * width));
}

std::string WindowModel::status_text() {
  std::string text;
  if (const ViewPlane* plane = shown_plane()) {
    text += fmt::format("{}   {}/{}", plane->name, session_.state.plane + 1, planes_.size());
    const auto drawn = drawn_here();
    if (drawn && is_dropped(*drawn)) text += "   dropped";
    if (session_.state.pointer == PointerMode::edit && organ_ < scene_.contours.size())
      text += fmt::format("   editing {}, reach {:g} mm", scene_.contours[organ_].stack.name, session_.state.reach_mm);
    const std::string agreement = to_text(cut(), scene_);
    text += "\n" + agreement;
  }
  for (const TaskStatus& task : {solve_.status(), segmentation_.status()})
    if (task.state == TaskState::running)
      text += fmt::format("\n{}: {:.0f} %, {:.0f} s   (Esc stops it)", task.stage.empty() ? "starting" : task.stage,
                          100 * task.fraction, task.seconds);
  if (morph_.count() > 0) text += fmt::format("\nframe {} of {}", morph_.position() + 1, morph_.count());
  if (replayed_contours())
    text += fmt::format("\nlevel set at {:.2f} mm, state {}/{}", replay_.states[replay_player_.position()].time_mm,
                        replay_player_.position() + 1, replay_player_.count());
  if (!pointer_text_.empty()) text += "\n" + pointer_text_;
  return text + "\n" + message_;
}

/// Says once that work has come to nothing.
void WindowModel::tell_end(const TaskStatus& task, TaskState& told) {
  if (std::exchange(told, task.state) == task.state) return;
  if (task.state == TaskState::failed) say(task.message);
  if (task.state == TaskState::cancelled) say("stopped; nothing was changed");
}

void WindowModel::tick(double seconds) {
  try {
    if (auto solved = solve_.take()) take_surfaces(std::move(*solved));
    if (auto found = segmentation_.take()) take_segmentation(std::move(*found));
  } catch (const Error& error) {
    say(error.what());
  }
  tell_end(solve_.status(), solve_told_);
  tell_end(segmentation_.status(), segmentation_told_);
  if (morph_.advance(seconds)) show_layers();
  if (replay_player_.advance(seconds)) {
    changed(WindowPart::slice);
    changed(WindowPart::text);
    if (replay_player_.position() + 1 == replay_player_.count()) replay_player_.pause();
  }
}

}  // namespace isostack
