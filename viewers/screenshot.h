#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "viewers/picture.h"
#include "viewers/scene.h"

namespace isostack {

struct ScreenshotOptions {
  int width_pixels = 1200;
  int height_pixels = 900;
  bool dark = false;                              ///< light drawing on a dark ground, for slides
  Eigen::Vector3d view_from = {0.5, -0.9, 0.35};  ///< direction from the scene's centre to the camera, LPS
};

/// Draws the scene in parallel projection, superior up, framed on all that is in it; slices are grey from their 1st to
/// 99th percentile. To be called from one thread at a time.
/// Throws InputError when there is nothing to draw, no display to draw with, or the size is not 64..8000 pixels a side.
Picture draw_picture(const Scene& scene, const ScreenshotOptions& options = {});

/// The same, written as PNG; the file appears whole or not at all. Throws InputError also when it cannot be written.
void save_screenshot(const Scene& scene, const std::filesystem::path& png, const ScreenshotOptions& options = {});

}  // namespace isostack
