#include "viewers/window/view_keys.h"

#include <fmt/format.h>

#include <array>

namespace isostack {

namespace {

using enum ViewAction;

constexpr std::array keys = std::to_array<ViewKey>({
    {"Up", false, next_plane, "Up, Down", "next, previous slice (or the wheel over the slice)"},
    {"Down", false, previous_plane, "", ""},
    {"Prior", false, ten_planes_on, "PageUp, PageDown", "ten slices on, back"},
    {"Next", false, ten_planes_back, "", ""},
    {"Home", false, first_plane, "Home, End", "first, last slice"},
    {"End", false, last_plane, "", ""},
    {"1", false, look_anterior, "1 2  3 4  5 6", "look from anterior, posterior, left, right, superior, inferior"},
    {"2", false, look_posterior, "", ""},
    {"3", false, look_left, "", ""},
    {"4", false, look_right, "", ""},
    {"5", false, look_superior, "", ""},
    {"6", false, look_inferior, "", ""},
    {"0", false, look_oblique, "0", "look obliquely at everything"},
    {"Tab", false, next_layout, "Tab", "3D and slice, 3D only, slice only"},
    {"b", false, side_by_side, "b", "a second result side by side"},
    {"s", false, show_surfaces, "s c x l", "surfaces, contours, cut lines, marks on and off"},
    {"c", false, show_contours, "", ""},
    {"x", false, show_cut_lines, "", ""},
    {"l", false, show_marks, "", ""},
    {"i", false, next_images, "i", "3D: the shown slice, all slices, none"},
    {"k", false, next_clip, "k", "clip surfaces at the shown slice: not, one side, the other"},
    {"o", false, next_opacity, "o", "surfaces solid, half or a quarter see-through"},
    {"w", false, wire, "w", "surfaces as wire"},
    {"bracketright", false, wider_grey, "] [", "less, more contrast"},
    {"bracketleft", false, narrower_grey, "", ""},
    {"plus", false, brighter, "+ -", "brighter, darker"},
    {"equal", false, brighter, "", ""},
    {"minus", false, darker, "", ""},
    {"a", false, automatic_grey, "a", "automatic contrast"},
    {"p", false, pick_mode, "p", "a click picks a point: mm, value, organ, distance"},
    {"m", false, measure_mode, "m", "two clicks measure a distance"},
    {"e", false, edit_mode, "e", "slice: drag a contour's point; a click on the line adds one"},
    {"g", false, seed_mode, "g", "a click places a seed"},
    {"BackSpace", false, clear_marks, "Backspace", "remove picks, distances and seeds"},
    {"n", false, next_organ, "n", "the next organ is edited or gets the seeds"},
    {"Delete", false, delete_point, "Delete", "remove the point under the pointer"},
    {"d", false, drop_slice, "d", "drop the shown slice"},
    {"period", false, longer_reach, ". ,", "more, fewer neighbours follow a dragged point"},
    {"comma", false, shorter_reach, "", ""},
    {"z", true, undo, "Ctrl-Z, u", "undo"},
    {"u", false, undo, "", ""},
    {"y", true, redo, "Ctrl-Y, r", "do again"},
    {"r", false, redo, "", ""},
    {"Return", false, solve, "Return", "solve the surface anew, in the background"},
    {"KP_Enter", false, solve, "", ""},
    {"Escape", false, cancel, "Esc", "stop that"},
    {"t", false, segment, "t", "segment from the seeds anew"},
    {"v", false, replay, "v", "replay how the level set came to rest on this slice"},
    {"space", false, play, "Space", "morph: play, pause"},
    {"Right", false, next_frame, "Right, Left", "morph: next, previous frame"},
    {"Left", false, previous_frame, "", ""},
    {"s", true, save_session, "Ctrl-S", "save the session"},
    {"p", true, save_picture, "Ctrl-P", "save a picture"},
    {"question", false, help, "?", "this list"},
    {"q", false, quit, "q", "close"},
    {"q", true, quit, "", ""},
});

}  // namespace

std::span<const ViewKey> view_keys() { return keys; }

std::optional<ViewAction> action_of(std::string_view symbol, bool control) {
  for (const ViewKey& key : keys)
    if (key.symbol == symbol && key.control == control) return key.action;
  return std::nullopt;
}

std::string key_help() {
  std::string text;
  for (const ViewKey& key : keys)
    if (!key.label.empty()) text += fmt::format("{:<18}{}\n", key.label, key.help);
  return text;
}

}  // namespace isostack
