#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "viewers/scene.h"

namespace isostack {

struct ScreenshotOptions {
  int width_pixels = 1200;
  int height_pixels = 900;
  bool dark = false;
  Eigen::Vector3d view_from = {0.5, -0.9, 0.35};  ///< direction from the scene's centre to the camera, LPS
};

/// Draws the scene and writes it as PNG; the file appears whole or not at all.
/// Throws InputError when there is nothing to draw or no display to draw with.
void save_screenshot(const Scene& scene, const std::filesystem::path& png, const ScreenshotOptions& options = {});

}  // namespace isostack
