#include <cmath>
#include <cstdio>
#include <numbers>

#include "io/meshes/write_mesh.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/reconstruct.h"
#include "segmentation/segment.h"
#include "viewers/scene.h"

// A bright disc on three slices becomes a closed surface, written as PLY.
int main(int, char** argv) {
  isostack::SliceStack stack{.name = "disc", .slices = {}, .warnings = {}};
  for (int k = 0; k < 3; ++k) {
    isostack::Slice slice{.name = "slice " + std::to_string(k), .pose = {}, .pixels = isostack::Image<float>(40, 40)};
    slice.pose.origin_mm.z() = 4 * k;
    for (int row = 0; row < 40; ++row)
      for (int column = 0; column < 40; ++column)
        slice.pixels(row, column) = static_cast<float>(10 - std::hypot(row - 20, column - 20));
    stack.slices.push_back(slice);
  }
  const isostack::ContourStack contours = isostack::segment(stack, {.level = 0});
  const isostack::Reconstruction result = isostack::reconstruct(contours, {});
  isostack::write_mesh(result.surface, argv[1]);
  const isostack::MeshMeasures measures = isostack::measure(result.surface);
  std::printf("volume %.0f mm3, %s\n", measures.volume_mm3, measures.watertight() ? "closed" : "open");
  const double least = std::numbers::pi * 100 * 8;  // the cylinder between the outer slices
  return measures.watertight() && measures.volume_mm3 > 0.95 * least ? 0 : 1;
}
