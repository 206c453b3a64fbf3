#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

#include "viewers/grey_window.h"
#include "viewers/scene.h"

namespace isostack {

struct PageOptions {
  bool dark = false;
  Eigen::Vector3d view_from = {0.5, -0.9, 0.35};  ///< direction from the scene's centre to the camera, LPS
  std::optional<GreyWindow> grey = std::nullopt;  ///< none: automatic, from all slices
  std::size_t most_triangles = 600'000;           ///< of each surface; a larger one is simplified
  std::size_t most_image_pixels = 12'000'000;     ///< of all images together; beyond they are made smaller
};

/// One HTML file that shows the scene in any browser with WebGL, without a server and without asking the network for
/// anything (it forbids itself to): the scene turns, moves and zooms, layers can be switched, images scrolled. It holds
/// names of organs, the title and what is drawn, and nothing else of the inputs: images are 8-bit PNGs. Coordinates are
/// rounded to 1/65535 of a surface's longest side. Needs no display. Throws InputError when there is nothing to show or
/// something that cannot be shown.
std::string page_html(const Scene& scene, const PageOptions& options = {});

/// The same as a file, which appears whole or not at all. Throws InputError also when it cannot be written.
void save_page(const Scene& scene, const std::filesystem::path& html, const PageOptions& options = {});

}  // namespace isostack
