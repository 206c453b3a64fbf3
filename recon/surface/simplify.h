#pragma once

#include <cstddef>

#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

struct SimplifyOptions {
  double tolerance_mm = 0;    ///< largest distance between the simplified and the given surface, both ways; 0: any
  std::size_t triangles = 0;  ///< stops at this many; 0: as few as the tolerance allows
};

/// The same surface in fewer triangles: edges collapse in the order of the quadric error they cause (Garland &
/// Heckbert 1997). Each collapse is checked before it is made: points of the given surface stay within the tolerance
/// of the triangles they belong to (Klein, Liebich & Straßer 1996), and points on the new triangles within it of the
/// given surface. The result is measured, and made again with a smaller limit where it misses. Parts and handles stay,
/// borders exactly. Without a tolerance the distance is halved as long as the number can still be reached. It has more
/// triangles than asked for where fewer would break that or the tolerance. Without normals. Throws GeometryError when
/// the mesh is not 2-manifold.
TriangleMesh simplify(const TriangleMesh& mesh, const SimplifyOptions& options, const Progress& progress = {});

/// Largest distance from either mesh's vertices and from points drawn on it to the other mesh, mm.
double largest_distance_mm(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace isostack
