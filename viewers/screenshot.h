#pragma once

#include <filesystem>
#include <vector>

#include "recon/geometry/picture.h"
#include "recon/geometry/progress.h"
#include "viewers/scene.h"
#include "viewers/scene_look.h"

namespace isostack {

struct ScreenshotOptions {
  int width_pixels = 1200;
  int height_pixels = 900;
  SceneLook look = {};
};

/// Draws the scene in parallel projection, superior up, framed on all that is visible unless the look says otherwise
/// (pictures of one sequence share a frame). To be called from one thread at a time.
/// Throws InputError when there is nothing to draw, no display to draw with, or the size is not 64..8000 pixels a side.
Picture draw_picture(const Scene& scene, const ScreenshotOptions& options = {});

/// The same, written as PNG; the file appears whole or not at all. Throws InputError also when it cannot be written.
void save_screenshot(const Scene& scene, const std::filesystem::path& png, const ScreenshotOptions& options = {});

/// `count` pictures of one turn about the body's axis at one scale, the first as draw_picture() sees it; the camera
/// goes on from left to anterior. Throws as draw_picture(), Cancelled, and InputError for a count below 2.
std::vector<Picture> draw_turntable(const Scene& scene, int count, const ScreenshotOptions& options = {},
                                    const Progress& progress = {});

}  // namespace isostack
