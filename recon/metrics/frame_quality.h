#pragma once

#include <cstddef>

#include "recon/morphing/shape.h"

namespace isostack {

/// What one frame of a morph is, in numbers. All zero for a shape without contours or triangles.
struct FrameQuality {
  std::size_t components = 0;  ///< pieces of a figure; connected surfaces of a mesh (a cavity has one of its own)
  std::size_t holes = 0;       ///< of a figure; of a mesh the handles of all its surfaces together (genus)
  double content = 0;          ///< area of a figure, mm²; volume of a body, mm³
  double boundary = 0;         ///< length of the outline, mm; area of the surface, mm²
  /// Extremes of the outline's curvature, or 1 % and 99 % quantiles over the vertices of the surface's mean curvature,
  /// which a few bad triangles do not move; 1/mm, positive where convex.
  double lowest_curvature = 0, highest_curvature = 0;
  double largest_curvature() const;  ///< the larger of the two without their signs
};

struct FrameQualityOptions {
  /// Outlines are seen at this scale along them (contour_measures.h): nothing sharper than 2 / scale. 0: a pixel.
  double curvature_scale_mm = 0;
};

/// Throws InputError when a triangle names a vertex that does not exist.
FrameQuality frame_quality(const Shape& shape, const FrameQualityOptions& options = {});

}  // namespace isostack
