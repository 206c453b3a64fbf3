#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "recon/geometry/picture.h"
#include "viewers/scene.h"

namespace isostack {

struct ScreenshotOptions {
  int width_pixels = 1200;
  int height_pixels = 900;
  bool dark = false;                                   ///< light drawing on a dark ground, for slides
  Eigen::Vector3d view_from = {0.5, -0.9, 0.35};       ///< direction from the scene's centre to the camera, LPS
  std::vector<Eigen::Vector3d> framed_points_mm = {};  ///< the picture is framed on them; empty: on all in the scene
  double surface_opacity = 1;                          ///< 0 to 1: contours and slices show through
  bool marks = true;                                   ///< scale bar and the cube with the patient's directions
};

/// Draws the scene in parallel projection, superior up, framed on all that is in it unless
/// the options say otherwise (pictures of one sequence share a frame); slices are grey from their 1st to
/// 99th percentile. To be called from one thread at a time.
/// Throws InputError when there is nothing to draw, no display to draw with, or the size is not 64..8000 pixels a side.
Picture draw_picture(const Scene& scene, const ScreenshotOptions& options = {});

/// The same, written as PNG; the file appears whole or not at all. Throws InputError also when it cannot be written.
void save_screenshot(const Scene& scene, const std::filesystem::path& png, const ScreenshotOptions& options = {});

}  // namespace isostack
