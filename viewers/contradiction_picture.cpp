#include "viewers/contradiction_picture.h"

#include <fmt/format.h>

#include <array>

#include "viewers/offscreen_window.h"
#include "viewers/scene_points.h"
#include "viewers/scene_view.h"
#include "viewers/view_planes.h"

namespace isostack {

namespace {

// Of the first and the second slice, apart on grey images and on white.
constexpr std::array<Color, 2> slice_colours = {{{230, 85, 13}, {33, 113, 205}}};

/// Shorter stretches, against the longest, would only hide it.
constexpr double least_share = 0.1;

/// The image in the slice's plane, if there is one, to be shown.
std::optional<SceneSlice> image_of(const ContourSlice& slice, const std::vector<SceneSlice>& images) {
  for (const SceneSlice& item : images)
    if (in_one_plane(item.image.pose, slice.pose, 0.1 * item.image.pose.spacing_mm.minCoeff()))
      return SceneSlice{.image = item.image};
  return std::nullopt;
}

SceneMark mark_of(const Contradiction& place) {
  SceneMark mark{.from_mm = place.ends[0].point_mm,
                 .to_mm = place.ends[1].point_mm,
                 .text = fmt::format("{:.1f} mm", place.length_mm)};
  if (place.distance_mm < 0.7 * place.length_mm) mark.text += fmt::format(" ({:.1f} apart)", place.distance_mm);
  return mark;
}

std::string name_of(const ContourSlice& slice, const char* otherwise) {
  return slice.name.empty() ? otherwise : slice.name;
}

/// Both slices with their images and the marks.
Scene pair_scene(const Scene& scene, const ContradictingPair& worst) {
  const std::vector<ContourSlice>& slices = scene.contours[worst.organ].stack.slices;
  Scene both;
  const std::array<std::size_t, 2> indices = {worst.pair.first, worst.pair.second};
  for (std::size_t i = 0; i < 2; ++i) {
    const ContourSlice& slice = slices[indices[i]];
    both.contours.push_back({.stack = {.name = slice.name, .slices = {slice}, .color = slice_colours[i]}});
    if (std::optional<SceneSlice> image = image_of(slice, scene.slices)) both.slices.push_back(std::move(*image));
  }
  for (const Contradiction& place : worst.pair.places)
    if (place.length_mm > least_share * worst.pair.largest_mismatch_mm) both.marks.push_back(mark_of(place));
  both.title = fmt::format("{}: {} and {} contradict each other by up to {:.1f} mm",
                           scene.contours[worst.organ].stack.name, name_of(slices[indices[0]], "a slice"),
                           name_of(slices[indices[1]], "another"), worst.pair.largest_mismatch_mm);
  return both;
}

/// Both planes are seen aslant, from the side nearest to `wanted`.
Eigen::Vector3d view_of_both(const SlicePose& first, const SlicePose& second, const Eigen::Vector3d& wanted) {
  const auto towards = [&](const Eigen::Vector3d& direction) -> Eigen::Vector3d {
    return direction.dot(wanted) < 0 ? Eigen::Vector3d(-direction) : direction;
  };
  const Eigen::Vector3d line = first.normal().cross(second.normal()).normalized();
  return towards(first.normal()) + towards(second.normal()) + 0.6 * towards(line);
}

/// What is framed: the contours of both, with some room.
std::vector<Eigen::Vector3d> contour_points(const Scene& both) {
  return visible_points({.contours = both.contours, .marks = both.marks});
}

}  // namespace

std::optional<ContradictingPair> worst_pair(const Scene& scene) {
  std::optional<ContradictingPair> worst;
  for (std::size_t organ = 0; organ < scene.contours.size(); ++organ)
    for (SlicePair& pair : find_contradictions(scene.contours[organ].stack, {.refuse_duplicates = false}).pairs)
      if (!pair.places.empty() && (!worst || pair.largest_mismatch_mm > worst->pair.largest_mismatch_mm))
        worst = {.organ = organ, .pair = std::move(pair)};
  return worst;
}

Picture draw_contradiction(const Scene& scene, const ContradictingPair& worst, const ScreenshotOptions& options) {
  const Scene both = pair_scene(scene, worst);
  require_drawable(both);
  OffscreenWindow window(options.width_pixels, options.height_pixels);
  SceneLook look = options.look;
  look.quality = Quality::fast;
  look.framed_points_mm = contour_points(both);
  look.filled = 0.6;
  if (!look.grey) look.grey = automatic_grey_window(scene);
  const std::vector<ContourSlice>& slices = scene.contours[worst.organ].stack.slices;
  look.view_from = view_of_both(slices[worst.pair.first].pose, slices[worst.pair.second].pose, options.look.view_from);
  const SceneView in_space(both, look, window.window(), {0, 0, 0.6, 1});

  std::array<Scene, 2> flat = {both, both};
  std::array<std::optional<SceneView>, 2> flat_views;
  for (std::size_t i = 0; i < 2; ++i) {
    const ContourSlice& slice = slices[i == 0 ? worst.pair.first : worst.pair.second];
    flat[i].title = i == 0 ? name_of(slice, "first slice") + " (orange)" : name_of(slice, "second slice") + " (blue)";
    // The other image is seen from its edge and would only hide the contours.
    flat[i].slices.clear();
    if (std::optional<SceneSlice> image = image_of(slice, scene.slices)) flat[i].slices.push_back(std::move(*image));
    SceneLook face_on = facing(slice.pose, look);
    face_on.filled = 0.72;
    const double bottom = i == 0 ? 0.5 : 0;
    flat_views[i].emplace(flat[i], face_on, window.window(), Eigen::Vector4d(0.6, bottom, 1, bottom + 0.5));
  }
  return window.draw();
}

}  // namespace isostack
