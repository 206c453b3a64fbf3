// What the pointer does: picks, distances, seeds, and contours that are dragged.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "recon/geometry/errors.h"
#include "viewers/window/window_model.h"

namespace isostack {

namespace {

/// The organs that have seeds, then a new one, then what is not wanted, then from the start.
std::string next_seed_name(const std::vector<ViewSeed>& seeds, const std::string& current) {
  std::vector<std::string> names = {ViewSeed().name};
  for (const ViewSeed& seed : seeds)
    if (seed.name != unwanted_seed && std::ranges::find(names, seed.name) == names.end()) names.push_back(seed.name);
  const auto has_seed = [&](const std::string& name) { return std::ranges::count(seeds, name, &ViewSeed::name) > 0; };
  if (std::ranges::all_of(names, has_seed)) names.push_back(fmt::format("{} {}", ViewSeed().name, names.size() + 1));
  names.emplace_back(unwanted_seed);
  const auto at = std::ranges::find(names, current);
  return at == names.end() || at + 1 == names.end() ? names.front() : *(at + 1);
}

}  // namespace

bool WindowModel::act_on_marks(ViewAction action) {
  using enum ViewAction;
  switch (action) {
    case pick_mode:
      set_pointer(PointerMode::pick, "click a point");
      return true;
    case measure_mode:
      set_pointer(PointerMode::measure, "click the two ends of a distance");
      return true;
    case edit_mode:
      set_pointer(PointerMode::edit, "on the slice: drag a point of the contour; click its line to add one");
      return true;
    case seed_mode:
      set_pointer(PointerMode::seed, "click within the organ; n seeds another or what is not wanted; t segments");
      return true;
    case next_organ:
      if (session_.state.pointer != PointerMode::seed) return false;
      seed_name_ = next_seed_name(session_.state.seeds, seed_name_);
      say(seed_name_ == unwanted_seed ? "click on what is not wanted" : "click within " + seed_name_);
      return true;
    case clear_marks:
      picks_.clear();
      session_.state.measurements.clear();
      session_.state.seeds.clear();
      seed_name_ = ViewSeed().name;
      measuring_from_.reset();
      update_marks();
      say("picks, distances and seeds are removed");
      return true;
    default:
      return false;
  }
}

void WindowModel::set_pointer(PointerMode mode, const char* says) {
  session_.state.pointer = mode;
  measuring_from_.reset();
  changed(WindowPart::slice);
  say(says);
}

void WindowModel::point_at(const std::optional<Eigen::Vector2d>& place_mm, double near_mm) {
  pointer_mm_ = place_mm;
  pointer_near_mm_ = near_mm;
  std::string text;
  if (place_mm && shown_plane()) {
    const Eigen::Vector3d point = shown_plane()->pose.slice_to_world(*place_mm);
    text = fmt::format("L {:.1f}  P {:.1f}  S {:.1f} mm", point.x(), point.y(), point.z());
    if (shown_plane()->image) {
      const Slice& image = scene_.slices[*shown_plane()->image].image;
      if (const auto grey = grey_at(image, *place_mm)) text += fmt::format("   value {:g}", *grey);
    }
  }
  if (text == pointer_text_) return;
  pointer_text_ = text;
  changed(WindowPart::text);
}

void WindowModel::press(const Eigen::Vector2d& place_mm, double near_mm) {
  if (!shown_plane()) return;
  try {
    if (session_.state.pointer == PointerMode::edit)
      begin_edit(place_mm, near_mm);
    else
      use_point(shown_plane()->pose.slice_to_world(place_mm));
  } catch (const Error& error) {
    say(error.what());
  }
}

void WindowModel::click(const Ray& ray) {
  std::optional<Eigen::Vector3d> point = hit_on_surfaces(ray, scene_.surfaces, clip());
  const bool shows_image = session_.state.layers.images != ImagesShown::none;
  if (const ViewPlane* plane = shown_plane(); plane && (shows_image || !point)) {
    const auto on_plane = hit_on_plane(ray, *plane);
    if (on_plane &&
        (!point || (*on_plane - ray.origin_mm).dot(ray.direction) < (*point - ray.origin_mm).dot(ray.direction)))
      point = on_plane;
  }
  if (point)
    use_point(*point);
  else
    say("there is nothing at that point");
}

void WindowModel::use_point(const Eigen::Vector3d& point_mm) {
  ViewState& state = session_.state;
  if (state.pointer == PointerMode::measure && !measuring_from_) {
    measuring_from_ = point_mm;
    say("now the other end");
  } else if (state.pointer == PointerMode::measure) {
    state.measurements.push_back({*measuring_from_, point_mm});
    measuring_from_.reset();
    say(fmt::format("{:.2f} mm", state.measurements.back().length_mm()));
  } else if (state.pointer == PointerMode::seed) {
    state.seeds.push_back({point_mm, seed_name_});
    const auto count = std::ranges::count(state.seeds, seed_name_, &ViewSeed::name);
    const std::string of = seed_name_ == unwanted_seed ? "what is not wanted" : seed_name_;
    say(fmt::format("{} of {}; t segments", count == 1 ? "a seed" : fmt::format("{} seeds", count), of));
  } else {
    pick(point_mm);
  }
  update_marks();
}

void WindowModel::pick(const Eigen::Vector3d& point_mm) {
  picks_.push_back(facts_about(point_mm, scene_, shown_plane()));
  say(to_text(picks_.back()));
}

void WindowModel::update_marks() {
  session_.state.picks_mm.clear();
  scene_.marks.clear();
  for (const PointFacts& pick : picks_) session_.state.picks_mm.push_back(pick.point_mm);
  for (const Measurement& one : session_.state.measurements)
    scene_.marks.push_back({one.from_mm, one.to_mm, fmt::format("{:.1f} mm", one.length_mm())});
  beside_.marks = scene_.marks;
  show_layers();
}

std::optional<ViewPlane::Drawn> WindowModel::drawn_here() const {
  if (const ViewPlane* plane = shown_plane())
    for (const ViewPlane::Drawn& drawn : plane->contours)
      if (drawn.organ == organ_) return drawn;
  return std::nullopt;
}

void WindowModel::begin_edit(const Eigen::Vector2d& place_mm, double near_mm) {
  const auto drawn = drawn_here();
  if (!drawn) return say("there is no contour of the edited organ on this slice; n takes the next organ");
  const ContourSlice& slice = edits_.organs()[drawn->organ].slices[drawn->slice];
  const Eigen::Vector2d place = slice.pose.world_to_slice(shown_plane()->pose.slice_to_world(place_mm));
  ContourEdit move{.kind = EditKind::move_point, .organ = drawn->organ, .slice = drawn->slice, .to_mm = place};
  move.reach_mm = session_.state.reach_mm;
  Drag drag{.drawn = *drawn, .step = {}, .contours = slice.contours};
  const NearestPoint corner = nearest_point(slice.contours, place, false);
  const NearestPoint edge = nearest_point(slice.contours, place, true);
  if (corner.distance_mm <= near_mm) {
    move.contour = corner.contour, move.point = corner.point;
    drag.step = {move};
  } else if (edge.distance_mm <= near_mm) {
    move.contour = edge.contour, move.point = edge.point;
    ContourEdit add = move;
    add.kind = EditKind::add_point;
    drag.step = {add, move};
  } else {
    return say("there is no contour that near; click closer to it");
  }
  drag_ = std::move(drag);
}

void WindowModel::drag(const Eigen::Vector2d& place_mm) {
  if (!drag_ || !shown_plane()) return;
  const ContourSlice& slice = edits_.organs()[drag_->drawn.organ].slices[drag_->drawn.slice];
  drag_->has_moved = true;
  drag_->step.back().to_mm = slice.pose.world_to_slice(shown_plane()->pose.slice_to_world(place_mm));
  try {
    std::vector<Contour> contours = slice.contours;
    for (const ContourEdit& edit : drag_->step) contours = edited(std::move(contours), edit, slice.name);
    drag_->contours = std::move(contours);
    drag_->is_valid = true;
  } catch (const Error& error) {
    drag_->is_valid = false;
    say(error.what());
  }
  changed(WindowPart::slice);
}

void WindowModel::release() {
  if (!drag_) return;
  const Drag done = std::move(*drag_);
  drag_.reset();
  changed(WindowPart::slice);
  if (done.step.size() == 1 && !done.has_moved) return;
  try {
    if (done.is_valid) apply(done.step);
  } catch (const Error& error) {
    say(error.what());
  }
}

}  // namespace isostack
