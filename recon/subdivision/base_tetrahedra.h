#pragma once

#include <Eigen/Core>

#include "recon/subdivision/surface_domain.h"

namespace isostack {

/// Tetrahedra between two level-0 meshes that lie on one domain (sphere_base() or torus_base() with equal periods), by
/// the rules (a) to (c) of Ohbuchi, Kokojima & Takahashi 2001, Section 2.2.1. One column each; vertices of `first`
/// come first, those of `second` are numbered on. With p, q, r counter-clockwise a tetrahedron (vertex of `first`, p,
/// q, r of `second`) is positive; all are. They form a 3-manifold whose boundary is the two meshes, domain × [0, 1].
///
/// The paper searches paths on one mesh's edges for its embedding of the other's dual graph, and merges faces where it
/// finds none. Here both dual graphs are drawn on the domain, with convex cells round the vertices (Voronoi cells), one
/// over the other: a vertex of one in a cell of the other is a tetrahedron by rule (a) or (c), a crossing of two edges
/// one by rule (b). Two convex cells have one common part, and two edges cross once, so that the tetrahedra always form
/// a manifold: nothing is searched or merged, and what lies near on the domain is joined. Equal meshes give three
/// tetrahedra for each triangle, the least there can be.
///
/// Throws GeometryError if numbers were too coarse for that.
Eigen::MatrixXi base_tetrahedra(const DomainMesh& first, const DomainMesh& second);

}  // namespace isostack
