#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "recon/geometry/color.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/picture.h"

namespace isostack {

/// The part of a slice's plane that a picture shows; pictures of one sequence share it.
struct PictureFrame {
  Eigen::AlignedBox2d box_mm;  ///< slice coordinates; x grows to the picture's right, y downwards
  double pixels_per_mm = 1;

  int width_pixels() const;
  int height_pixels() const;
};

/// The frame round all the contours, with a margin on every side, whose longer side has so many pixels. Throws
/// InputError when no contour has a point, a point is not finite, or the side is not 16..8000 pixels.
PictureFrame frame_round(const std::vector<std::vector<Contour>>& figures, int longer_side_pixels);

struct FigureLook {
  Color ground = {255, 255, 255};
  Color fill = {54, 96, 146};
};

/// The contours as a filled figure (even-odd), its edges smoothed by how much of a pixel it covers. Needs no display.
/// Without contours the picture is empty ground.
Picture draw_figure(const std::vector<Contour>& contours, const PictureFrame& frame, const FigureLook& look = {});

}  // namespace isostack
