#pragma once

#include <cstddef>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// How even the triangles of a mesh are.
struct MeshQuality {
  double shortest_edge_mm = 0, edge_percentile5_mm = 0, median_edge_mm = 0, edge_percentile95_mm = 0,
         longest_edge_mm = 0;
  double smallest_angle_deg = 0;       ///< of all corners
  double mean_smallest_angle_deg = 0;  ///< of the triangles' smallest angles: 60° for equilateral ones
  std::size_t corners_below_20_deg = 0;
};

/// Throws InputError on an empty mesh.
MeshQuality measure_quality(const TriangleMesh& mesh);

}  // namespace isostack
