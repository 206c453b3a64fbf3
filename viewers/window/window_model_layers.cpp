// What of the scene is shown.
#include "viewers/window/window_model.h"

namespace isostack {

bool WindowModel::act_on_layers(ViewAction action) {
  using enum ViewAction;
  ViewState& state = session_.state;
  const auto toggle = [](bool& layer) { layer = !layer; };
  const auto next = [](auto value, int count) {
    return static_cast<decltype(value)>((static_cast<int>(value) + 1) % count);
  };
  switch (action) {
    case show_surfaces:
      toggle(state.layers.surfaces);
      break;
    case show_contours:
      toggle(state.layers.contours);
      break;
    case show_cut_lines:
      toggle(state.layers.cut_lines);
      break;
    case show_marks:
      toggle(state.layers.marks);
      break;
    case next_images:
      state.layers.images = next(state.layers.images, 3);
      break;
    case next_clip:
      state.clip = next(state.clip, 3);
      break;
    case next_opacity:
      state.surface_opacity = state.surface_opacity > 0.75 ? 0.5 : state.surface_opacity > 0.4 ? 0.25 : 1;
      break;
    case wire:
      for (SceneSurface& surface : scene_.surfaces)
        surface.style = surface.style == SurfaceStyle::wire ? SurfaceStyle::shaded : SurfaceStyle::wire;
      break;
    case next_layout:
      if (shown_plane()) state.layout = next(state.layout, 3);
      changed(WindowPart::layout);
      break;
    case side_by_side:
      if (beside_.surfaces.empty()) say("there is no second result: open it with --beside");
      state.side_by_side = !state.side_by_side && !beside_.surfaces.empty();
      changed(WindowPart::layout);
      break;
    case play:
      morph_.play_or_pause();
      break;
    case next_frame:
      show_frame(static_cast<std::ptrdiff_t>(morph_.position()) + 1);
      break;
    case previous_frame:
      show_frame(static_cast<std::ptrdiff_t>(morph_.position()) - 1);
      break;
    default:
      return false;
  }
  if ((action == play || action == next_frame) && morph_.count() == 0)
    say("there is no morph: open its frames with --frames");
  show_layers();
  return true;
}

/// Passes the state on to the scenes' items.
void WindowModel::show_layers() {
  const ViewState& state = session_.state;
  session_.state.frame = morph_.position();
  std::vector<bool> was_visible;
  for (std::size_t i = 0; i < scene_.surfaces.size(); ++i) {
    SceneSurface& surface = scene_.surfaces[i];
    was_visible.push_back(surface.visible);
    const bool is_frame = i >= first_frame_ && i < first_frame_ + morph_.count();
    surface.visible = state.layers.surfaces && (!is_frame || i - first_frame_ == morph_.position());
    surface.opacity = state.surface_opacity;
    if (surface.visible != was_visible.back()) cut_.reset();
  }
  for (SceneSurface& surface : beside_.surfaces) {
    surface.visible = state.layers.surfaces;
    surface.opacity = state.surface_opacity;
  }
  for (Scene* scene : {&scene_, &beside_}) {
    for (SceneContours& contours : scene->contours) contours.visible = state.layers.contours;
    for (SceneMark& mark : scene->marks) mark.visible = state.layers.marks;
  }
  const std::size_t none = scene_.slices.size();
  const std::size_t shown = shown_plane() ? shown_plane()->image.value_or(none) : none;
  for (std::size_t i = 0; i < none; ++i)
    scene_.slices[i].visible =
        state.layers.images == ImagesShown::all || (state.layers.images == ImagesShown::shown_plane && i == shown);
  for (const WindowPart part : {WindowPart::looks, WindowPart::marks, WindowPart::slice}) changed(part);
}

}  // namespace isostack
