#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace isostack {

/// All that a key can do in the window.
enum class ViewAction {
  next_plane,
  previous_plane,
  ten_planes_on,
  ten_planes_back,
  first_plane,
  last_plane,
  look_anterior,
  look_posterior,
  look_left,
  look_right,
  look_superior,
  look_inferior,
  look_oblique,
  next_layout,
  side_by_side,
  show_surfaces,
  show_contours,
  show_cut_lines,
  show_marks,
  next_images,
  next_clip,
  next_opacity,
  wire,
  wider_grey,
  narrower_grey,
  brighter,
  darker,
  automatic_grey,
  pick_mode,
  measure_mode,
  edit_mode,
  seed_mode,
  clear_marks,
  next_organ,
  delete_point,
  drop_slice,
  longer_reach,
  shorter_reach,
  undo,
  redo,
  solve,
  cancel,
  segment,
  replay,
  play,
  next_frame,
  previous_frame,
  save_session,
  save_picture,
  help,
  quit
};

struct ViewKey {
  std::string_view symbol;  ///< X's name of the key's symbol
  bool control;             ///< held with it
  ViewAction action;
  std::string_view label;  ///< for people; empty: another key's entry says it
  std::string_view help;
};

std::span<const ViewKey> view_keys();

/// What a key does; nothing for one that is not bound.
std::optional<ViewAction> action_of(std::string_view symbol, bool control);

/// One line per key.
std::string key_help();

}  // namespace isostack
