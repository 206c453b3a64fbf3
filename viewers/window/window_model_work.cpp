// Edits, and what runs in the background.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/reconstruct_all.h"
#include "viewers/window/window_model.h"

namespace isostack {

bool WindowModel::act_on_edits(ViewAction action) {
  using enum ViewAction;
  const auto set_reach = [&](double factor) {
    session_.state.reach_mm = std::clamp(factor * session_.state.reach_mm, 0.1, 1000.0);
  };
  switch (action) {
    case next_organ:
      if (!scene_.contours.empty()) organ_ = (organ_ + 1) % scene_.contours.size();
      changed(WindowPart::slice);
      return true;
    case delete_point:
      delete_point_under_pointer();
      return true;
    case drop_slice:
      drop_shown_slice();
      return true;
    case longer_reach:
      set_reach(1.5);
      return true;
    case shorter_reach:
      set_reach(1 / 1.5);
      return true;
    case ViewAction::undo:
      this->undo();
      return true;
    case redo:
      if (!edits_.redo()) return say("there is nothing to do again"), true;
      contours_changed();
      say("done again; Return solves the surface anew");
      return true;
    default:
      return false;
  }
}

bool WindowModel::act_on_work(ViewAction action) {
  using enum ViewAction;
  switch (action) {
    case solve:
      start_solve();
      return true;
    case cancel:
      if (is_busy()) say("stopping");
      solve_.cancel();
      segmentation_.cancel();
      return true;
    case segment:
      start_segmentation();
      return true;
    case replay:
      if (replay_.states.empty() || !shown_plane() || shown_plane()->image != replay_.slice)
        return say("no evolution was recorded on this slice: t segments from the seeds and records it"), true;
      shows_replay_ = true;
      replay_player_.show(0);
      replay_player_.play_or_pause();
      changed(WindowPart::slice);
      return true;
    case ViewAction::save_session:
      this->save_session();
      return true;
    case save_picture:
      wants_picture_ = true;
      return true;
    default:
      return false;
  }
}

void WindowModel::apply(const EditStep& step) {
  edits_.apply(step);
  contours_changed();
  say("changed; Return solves the surface anew, u undoes it");
}

void WindowModel::undo() {
  if (edits_.undo()) {
    contours_changed();
    return say("undone; Return solves the surface anew");
  }
  if (!edits_before_segmentation_) return say("there is nothing to undo");
  edits_ = *std::exchange(edits_before_segmentation_, std::nullopt);
  session_.state.is_segmented = false;
  set_organs(edits_.organs());
  say("the contours before the segmentation are back");
}

void WindowModel::contours_changed() {
  const std::vector<ContourStack>& organs = edits_.organs();
  for (std::size_t organ = 0; organ < organs.size(); ++organ) {
    scene_.contours[organ].stack = organs[organ];
    for (std::size_t slice = 0; slice < organs[organ].slices.size(); ++slice)
      if (edits_.is_dropped(organ, slice)) scene_.contours[organ].stack.slices[slice].contours.clear();
  }
  if (!beside_.surfaces.empty()) beside_.contours = scene_.contours;
  session_.state.edits = edits_to_redo_.empty() ? edits_.steps() : edits_to_redo_;
  session_.state.is_solved = false;
  cut_.reset();
  for (const WindowPart part : {WindowPart::contours, WindowPart::marks, WindowPart::slice, WindowPart::text})
    changed(part);
}

void WindowModel::delete_point_under_pointer() {
  const auto drawn = drawn_here();
  if (!drawn || !pointer_mm_) return say("point at a contour's point on the slice");
  const ContourSlice& slice = edits_.organs()[drawn->organ].slices[drawn->slice];
  const Eigen::Vector2d place = slice.pose.world_to_slice(shown_plane()->pose.slice_to_world(*pointer_mm_));
  const NearestPoint nearest = nearest_point(slice.contours, place, false);
  if (!(nearest.distance_mm <= pointer_near_mm_)) return say("point at a contour's point on the slice");
  apply({{.kind = EditKind::delete_point,
          .organ = drawn->organ,
          .slice = drawn->slice,
          .contour = nearest.contour,
          .point = nearest.point}});
}

/// For every organ: a slice is dropped because its image is bad.
void WindowModel::drop_shown_slice() {
  EditStep step;
  if (shown_plane())
    for (const ViewPlane::Drawn& drawn : shown_plane()->contours)
      if (!is_dropped(drawn))
        step.push_back({.kind = EditKind::drop_slice, .organ = drawn.organ, .slice = drawn.slice});
  if (step.empty()) return say("there is no contour on this slice to drop");
  apply(step);
}

void WindowModel::start_solve() {
  std::vector<ContourStack> organs = edits_.kept_organs();
  if (std::all_of(organs.begin(), organs.end(), [](const ContourStack& organ) { return point_count(organ) == 0; }))
    return say("there are no contours to solve through");
  solve_.start([organs = std::move(organs), options = reconstruct_](const Progress& progress) {
    std::vector<ContourStack> drawn;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < organs.size(); ++i)
      if (point_count(organs[i]) > 0) drawn.push_back(organs[i]), places.push_back(i);
    std::vector<Reconstruction> solved = reconstruct_all(drawn, options, progress);
    std::vector<Reconstruction> by_organ(organs.size());
    for (std::size_t i = 0; i < solved.size(); ++i) by_organ[places[i]] = std::move(solved[i]);
    return by_organ;
  });
  say("solving in the background");
}

void WindowModel::take_surfaces(std::vector<Reconstruction> solved) {
  std::string text = "solved";
  for (std::size_t organ = 0; organ < solved.size() && organ < surface_of_organ_.size(); ++organ) {
    if (solved[organ].surface.triangles.empty()) continue;
    int& place = surface_of_organ_[organ];
    if (place < 0) {
      place = static_cast<int>(scene_.surfaces.size());
      scene_.surfaces.emplace_back();
      surface_revisions_.push_back(0);
    }
    SceneSurface& surface = scene_.surfaces[static_cast<std::size_t>(place)];
    surface.values.reset();  // they were of the surface before
    surface.mesh = std::move(solved[organ].surface);
    ++surface_revisions_[static_cast<std::size_t>(place)];
    const ReconstructReport& report = solved[organ].report;
    text += fmt::format("   {}: {:.2f} mm mean, {:.2f} mm largest from its contours", surface.mesh.name,
                        report.sections.mean_mm, report.sections.largest_mm);
  }
  session_.state.is_solved = true;
  cut_.reset();
  show_layers();
  say(text + fmt::format("   ({:.1f} s)", solve_.status().seconds));
}

void WindowModel::start_segmentation() {
  if (session_.state.seeds.empty()) return say("there is no seed: g, then click within the organ");
  const std::size_t replayed = shown_plane() ? shown_plane()->image.value_or(0) : 0;
  segmentation_.start([&scene = scene_, seeds = session_.state.seeds, replayed](const Progress& progress) {
    return segment_from_seeds(scene, seeds, replayed, progress);
  });
  say("segmenting in the background");
}

void WindowModel::set_organs(const std::vector<ContourStack>& organs) {
  for (std::size_t i = organs.size(); i < scene_.contours.size(); ++i) scene_.contours[i].stack = {};
  scene_.contours.resize(std::max(scene_.contours.size(), organs.size()));
  surface_of_organ_.resize(scene_.contours.size(), -1);
  if (organ_ >= organs.size()) organ_ = 0;
  contours_changed();
  planes_ = view_planes(scene_);
  show_plane(static_cast<std::ptrdiff_t>(session_.state.plane));
}

void WindowModel::take_segmentation(SeedSegmentation found) {
  if (!session_.state.is_segmented) edits_before_segmentation_ = std::move(edits_);
  edits_ = ContourEdits(std::move(found.organs));
  session_.state.is_segmented = true;
  replay_ = std::move(found.replay);
  replay_player_ = Playback(replay_.states.size(), 25);
  shows_replay_ = false;
  const bool was_solved = session_.state.is_solved;
  set_organs(edits_.organs());
  for (const EditStep& step : std::exchange(edits_to_redo_, {})) edits_.apply(step);
  contours_changed();
  if (was_solved) start_solve();
  say(fmt::format("segmented in {:.1f} s; Return solves the surface, v replays the level set",
                  segmentation_.status().seconds));
  if (!found.remarks.empty()) say(found.remarks.front());
}

void WindowModel::stop() {
  solve_.stop();
  segmentation_.stop();
}

void WindowModel::save_session() {
  write_view_session(session_, session_file_);
  say("saved " + session_file_.string());
}

}  // namespace isostack
