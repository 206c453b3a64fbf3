#pragma once

#include <cstddef>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// What a surface is, in numbers. Volume is signed: negative for a mesh turned inside out.
struct MeshMeasures {
  double volume_mm3 = 0;
  double area_mm2 = 0;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t components = 0;  ///< connected through shared vertices
  long euler_characteristic = 0;
  double genus = 0;                    ///< components − χ/2; meaningful when closed and manifold
  std::size_t boundary_edges = 0;      ///< edges with one triangle
  std::size_t non_manifold_edges = 0;  ///< edges with more than two triangles
  std::size_t flipped_edges = 0;       ///< edges whose two triangles disagree about the outside
  bool watertight() const { return boundary_edges == 0 && non_manifold_edges == 0 && flipped_edges == 0; }
};

/// Throws InputError when a triangle names a vertex that does not exist.
MeshMeasures measure(const TriangleMesh& mesh);

}  // namespace isostack
