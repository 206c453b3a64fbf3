#pragma once

#include <cstddef>

#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/surface/scalar_field.h"

namespace isostack {

struct RemeshOptions {
  double edge_length_mm = 1;           ///< edges end up between 4/5 and 4/3 of it, most of them
  int iterations = 10;                 ///< rounds of splitting, collapsing, flipping and relaxing
  double most_triangles = 2e7;         ///< refuses to make more
  const ScalarField* field = nullptr;  ///< vertices end on its zero set; none: on the mesh that was given
};

struct RemeshedSurface {
  TriangleMesh mesh;                     ///< without normals
  std::size_t vertices_off_surface = 0;  ///< no root of the field was found near them; they are on the given mesh
};

/// The same surface in nearly equilateral triangles of one size (Botsch & Kobbelt 2004): long edges are split, short
/// ones collapsed, edges flipped towards six neighbours a vertex, vertices moved within the surface towards the middle
/// of their neighbours and put back onto it. Parts, handles and borders stay: border edges and vertices exactly, so
/// edges near a border with other lengths are not all of the target's. Edges stay short where the surface is thinner
/// than they should be long. The result does not depend on the number of threads.
/// Throws GeometryError when the mesh is not 2-manifold or the result would have too many triangles.
RemeshedSurface remesh(const TriangleMesh& mesh, const RemeshOptions& options, const Progress& progress = {});

}  // namespace isostack
