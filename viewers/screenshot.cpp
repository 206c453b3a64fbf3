#include "viewers/screenshot.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/images/write_pictures.h"
#include "recon/geometry/errors.h"
#include "viewers/offscreen_window.h"
#include "viewers/scene_points.h"
#include "viewers/scene_view.h"

namespace isostack {

namespace {

/// Two circles round the points about the body's axis: they look the same from all sides.
std::vector<Eigen::Vector3d> drum_round(const std::vector<Eigen::Vector3d>& points_mm) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points_mm) box.extend(point);
  double radius_mm = 0;
  for (const Eigen::Vector3d& point : points_mm)
    radius_mm = std::max(radius_mm, (point - box.center()).head<2>().norm());
  constexpr int sides = 90;
  std::vector<Eigen::Vector3d> drum;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double z : {box.min().z(), box.max().z()})
      drum.emplace_back(box.center().x() + radius_mm * std::cos(angle), box.center().y() + radius_mm * std::sin(angle),
                        z);
  }
  return drum;
}

}  // namespace

Picture draw_picture(const Scene& scene, const ScreenshotOptions& options) {
  OffscreenWindow::require_size(options.width_pixels, options.height_pixels);
  require_drawable(scene);  // a scene that cannot be drawn is said to be so, display or not
  OffscreenWindow window(options.width_pixels, options.height_pixels);
  const SceneView view(scene, options.look, window.window());
  return window.draw();
}

void save_screenshot(const Scene& scene, const std::filesystem::path& png, const ScreenshotOptions& options) {
  write_png(draw_picture(scene, options), png);
}

std::vector<Picture> draw_turntable(const Scene& scene, int count, const ScreenshotOptions& options,
                                    const Progress& progress) {
  if (count < 2) throw InputError("turntable", "it has too few pictures", "ask for 2 or more");
  OffscreenWindow::require_size(options.width_pixels, options.height_pixels);
  require_drawable(scene);
  OffscreenWindow window(options.width_pixels, options.height_pixels);
  SceneLook look = options.look;
  look.framed_points_mm = drum_round(look.framed_points_mm.empty() ? visible_points(scene) : look.framed_points_mm);
  SceneView view(scene, look, window.window());
  std::vector<Picture> pictures;
  for (int i = 0; i < count; ++i) {
    progress.report("pictures", static_cast<double>(i) / count);
    view.aim(Eigen::AngleAxisd(-2 * std::numbers::pi * i / count, Eigen::Vector3d::UnitZ()) * look.view_from);
    pictures.push_back(window.draw());
  }
  return pictures;
}

}  // namespace isostack
