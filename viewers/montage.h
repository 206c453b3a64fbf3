#pragma once

#include <optional>

#include "recon/geometry/picture.h"
#include "recon/geometry/progress.h"
#include "viewers/scene.h"
#include "viewers/scene_look.h"

namespace isostack {

struct MontageOptions {
  int width_pixels = 1600;  ///< of the sheet, about
  std::size_t columns = 0;  ///< 0: as many as make the sheet about 4:3
  bool dark = false;
  std::optional<GreyWindow> grey = std::nullopt;  ///< none: automatic, from all slices
};

/// Every plane of the scene that has an image or contours, seen as the image is (columns to the right, rows down), all
/// at one scale: image, contours, and the lines along which the surfaces cut the plane. Below each its number and its
/// place along its normal in mm. Throws InputError as draw_picture(), and when there is no plane; Cancelled.
Picture draw_montage(const Scene& scene, const MontageOptions& options = {}, const Progress& progress = {});

}  // namespace isostack
