#pragma once

#include <vector>

#include "recon/subdivision/body_interpolator.h"
#include "recon/subdivision/simplicial_mesh.h"

namespace isostack {

/// The optimised interpolator with all vertices of its sources: where a vertex lies within a triangle of the finest
/// level (on the domain, so that no two change places), that triangle is cut up, and the tetrahedra on it with it.
/// What is drawn on the sources' triangles at their t is then the surface itself, through all its vertices, and all
/// frames stay closed manifolds. `mesh` is that of the finest level, its sources' vertices in their places.
SimplicialMesh with_source_vertices(const SimplicialMesh& mesh, const BodyInterpolator& interpolator,
                                    const SubdivisionLevels& levels);

}  // namespace isostack
