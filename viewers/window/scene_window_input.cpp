// Where input of the window goes.
#include <vtkRenderer.h>

#include <cstdlib>

#include "viewers/window/scene_window_parts.h"

namespace isostack {

namespace {

/// A button released nearer than this to where it went down has clicked, not dragged.
constexpr int click_pixels = 3;
/// How far beside a contour a click may be.
constexpr int near_pixels = 8;

}  // namespace

bool SceneWindow::press(int x, int y, PointerButton button) {
  ++events_;
  if (const auto frame = status_->frame_at(x, y, model_.morph())) {
    model_.show_frame(*frame);
    held_ = Held{button, x, y, x, y, false};
    return true;
  }
  const bool on_slice = slice_->renderer().GetDraw() && slice_->contains(x, y);
  held_ = Held{button, x, y, x, y, on_slice};
  if (!on_slice) return !scene_->contains(x, y) && !(beside_ && beside_->contains(x, y));
  if (button == PointerButton::left) model_.press(slice_->place_at(x, y), near_pixels * slice_->mm_per_pixel());
  return true;
}

bool SceneWindow::move(int x, int y) {
  ++events_;
  const bool on_slice = slice_->renderer().GetDraw() && slice_->contains(x, y);
  model_.point_at(on_slice ? std::optional(slice_->place_at(x, y)) : std::nullopt,
                  near_pixels * slice_->mm_per_pixel());
  if (!held_) return on_slice;
  const int right = x - held_->at_x, up = y - held_->at_y;
  held_->at_x = x, held_->at_y = y;
  if (const auto frame = status_->frame_at(x, held_->y, model_.morph())) return model_.show_frame(*frame), true;
  if (!held_->on_slice) return false;
  if (held_->button == PointerButton::left) {
    model_.drag(slice_->place_at(x, y));
  } else if (held_->button == PointerButton::middle) {
    slice_->pan(right, up);
    draw_slice_ = true;
  } else {
    const GreyWindow grey = model_.grey();
    const double width = static_cast<double>(grey.high) - grey.low,
                 level = (static_cast<double>(grey.high) + grey.low) / 2;
    model_.set_grey(grey_window_from(width * (1 + 0.005 * right), level - 0.003 * up * width));
  }
  return true;
}

bool SceneWindow::release(int x, int y) {
  ++events_;
  if (!held_) return false;
  const Held held = *held_;
  held_.reset();
  if (held.on_slice) {
    model_.release();
    return true;
  }
  const bool is_click = std::abs(x - held.x) <= click_pixels && std::abs(y - held.y) <= click_pixels;
  if (held.button == PointerButton::left && is_click)
    for (ScenePanel* panel : {&*scene_, beside_ ? &*beside_ : nullptr})
      if (panel && panel->contains(x, y)) {
        model_.click(panel->ray_at(x, y));
        break;
      }
  return false;  // the camera's motion ends, too
}

bool SceneWindow::wheel(int x, int y, bool forward, bool control) {
  ++events_;
  if (!slice_->renderer().GetDraw() || !slice_->contains(x, y)) return !scene_->contains(x, y);
  if (control) {
    slice_->zoom(forward ? 1.2 : 1 / 1.2);
    draw_slice_ = true;
  } else {
    model_.act(forward ? ViewAction::next_plane : ViewAction::previous_plane);
  }
  return true;
}

void SceneWindow::key(const std::string& symbol, bool control) {
  ++events_;
  if (const auto action = action_of(symbol, control)) model_.act(*action);
}

void SceneWindow::camera_moved() {
  set_moving(true);
  draw_scene_ = true;
}

}  // namespace isostack
