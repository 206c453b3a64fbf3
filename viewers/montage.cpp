#include "viewers/montage.h"

#include <fmt/format.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>

#include "recon/geometry/errors.h"
#include "viewers/contact_sheet.h"
#include "viewers/offscreen_window.h"
#include "viewers/plane_scene.h"
#include "viewers/scene_points.h"
#include "viewers/scene_view.h"

namespace isostack {

namespace {

/// The corners of a rectangle of this size in the plane, about the middle of what is there.
std::vector<Eigen::Vector3d> frame_in(const ViewPlane& plane, const Eigen::Vector2d& size_mm) {
  const Eigen::Vector2d centre = plane.extent_mm.center(), half = size_mm / 2;
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      corners.push_back(plane.pose.slice_to_world(centre + Eigen::Vector2d(x * half.x(), y * half.y())));
  return corners;
}

struct Layout {
  Eigen::Vector2d tile_mm = Eigen::Vector2d::Zero();
  std::size_t columns = 1;
  int width_pixels = 64, height_pixels = 64;
};

Layout layout_of(const std::vector<ViewPlane>& planes, const MontageOptions& options) {
  Layout layout;
  for (const ViewPlane& plane : planes) layout.tile_mm = layout.tile_mm.cwiseMax(plane.extent_mm.sizes());
  layout.tile_mm = layout.tile_mm.cwiseMax(1e-3);
  const double shape = std::clamp(layout.tile_mm.x() / layout.tile_mm.y(), 0.2, 5.0);
  const auto count = static_cast<double>(planes.size());
  layout.columns =
      options.columns > 0 ? options.columns : static_cast<std::size_t>(std::ceil(std::sqrt(count * 4 / (3 * shape))));
  layout.columns = std::min(layout.columns, planes.size());
  layout.width_pixels = std::clamp(options.width_pixels / static_cast<int>(layout.columns), 64, 2000);
  layout.height_pixels = std::clamp(static_cast<int>(layout.width_pixels / shape), 64, 2000);
  return layout;
}

Picture draw_plane(const Scene& flat, const SceneLook& look, OffscreenWindow& window) {
  const SceneView view(flat, look, window.window());
  Picture picture = window.draw();
  window.window().RemoveRenderer(&view.renderer());
  return picture;
}

}  // namespace

Picture draw_montage(const Scene& scene, const MontageOptions& options, const Progress& progress) {
  require_drawable(scene);
  std::vector<ViewPlane> planes = view_planes(scene);
  std::erase_if(planes, [](const ViewPlane& plane) { return !plane.image && plane.contours.empty(); });
  if (planes.empty()) throw InputError("montage", "there are no slices", "give it images or contours beside surfaces");
  const Layout layout = layout_of(planes, options);
  const bool several_families = planes.back().family > 0;
  SceneLook look{.dark = options.dark, .filled = 1, .marks = false, .grey = options.grey, .quality = Quality::fast};
  if (!look.grey) look.grey = automatic_grey_window(scene);
  OffscreenWindow window(layout.width_pixels, layout.height_pixels);
  std::vector<CaptionedPicture> tiles;
  for (const ViewPlane& plane : planes) {
    progress.report("pictures", static_cast<double>(tiles.size()) / static_cast<double>(planes.size()));
    look.framed_points_mm = frame_in(plane, layout.tile_mm);
    const double place_mm = plane.pose.normal().dot(plane.pose.origin_mm);
    const std::string family = several_families ? std::string(1, static_cast<char>('A' + plane.family % 26)) : "";
    tiles.push_back({draw_plane(plane_scene(scene, plane), facing(plane.pose, look), window),
                     fmt::format("{}{}: {:.1f} mm", family, tiles.size(), place_mm)});
  }
  ContactSheetLook sheet{.columns = layout.columns};
  if (options.dark) sheet.ground = {23, 26, 31}, sheet.ink = {230, 230, 230};
  return contact_sheet(tiles, sheet);
}

}  // namespace isostack
