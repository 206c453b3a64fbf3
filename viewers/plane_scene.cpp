#include "viewers/plane_scene.h"

#include <cmath>
#include <cstdint>

#include "viewers/cut_lines.h"
#include "viewers/palette.h"

namespace isostack {

namespace {

Color as_color(const Eigen::Vector3d& rgb) {
  const auto channel = [](double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); };
  return {channel(rgb.x()), channel(rgb.y()), channel(rgb.z())};
}

}  // namespace

Scene plane_scene(const Scene& scene, const ViewPlane& plane) {
  Scene flat;
  if (plane.image) flat.slices.push_back({.image = scene.slices[*plane.image].image});
  for (const ViewPlane::Drawn& drawn : plane.contours) {
    const SceneContours& organ = scene.contours[drawn.organ];
    if (!organ.visible) continue;
    flat.contours.push_back(
        {.stack = {.name = organ.stack.name,
                   .slices = {organ.stack.slices[drawn.slice]},
                   .color = organ.stack.color ? *organ.stack.color : as_color(organ_colours(drawn.organ).contour)}});
  }
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const SceneSurface& surface = scene.surfaces[i];
    if (!surface.visible) continue;
    std::vector<Contour> cut = cut_lines(surface.mesh, plane.pose);
    if (cut.empty()) continue;
    ContourSlice slice{.name = surface.mesh.name, .pose = plane.pose, .contours = std::move(cut)};
    slice.pose.origin_mm -= 1e-3 * plane.pose.normal();
    flat.contours.push_back(
        {.stack = {.name = surface.mesh.name,
                   .slices = {std::move(slice)},
                   .color = surface.mesh.color ? *surface.mesh.color : as_color(organ_colours(i).surface)}});
  }
  return flat;
}

}  // namespace isostack
