#pragma once

#include <cstddef>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/slice.h"
#include "recon/geometry/triangle_mesh.h"

class vtkRenderer;

namespace isostack {

/// Grey values drawn as black and as white.
struct GreyWindow {
  float low = 0;
  float high = 1;
};

/// The 1st and 99th percentile of all finite pixels of the slices.
GreyWindow grey_window_of(const std::vector<Slice>& slices);

/// Each adds what draws its argument, in world LPS mm, to the renderer. Colours follow from `organ_index`.
/// `opacity` is 1 for a solid surface.
void add_surface(const TriangleMesh& mesh, std::size_t organ_index, double opacity, vtkRenderer& renderer);
/// `width_pixels`: width of the lines on screen.
void add_contours(const ContourStack& organ, std::size_t organ_index, double width_pixels, vtkRenderer& renderer);
void add_slice(const Slice& slice, const GreyWindow& window, vtkRenderer& renderer);

}  // namespace isostack
