#pragma once

#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/slice.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// What there is to look at, all in world LPS mm.
struct Scene {
  std::string title = {};
  std::vector<TriangleMesh> surfaces = {};
  std::vector<ContourStack> contours = {};
  std::vector<Slice> slices = {};
};

}  // namespace isostack
