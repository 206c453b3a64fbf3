#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/geometry/triangle_mesh.h"
#include "recon/subdivision/subdivision_levels.h"
#include "recon/subdivision/surface_domain.h"

namespace isostack {

/// A surface with subdivision connectivity (the paper's TS-mesh): base triangles halved again and again, each vertex on
/// the surface it samples. Places of level k are those of the finest level's first vertices, so that what finer levels
/// add, the details, is the way from the middle of an edge to the vertex that halves it (Lounsbery et al. 1997 with
/// the lazy wavelet), and comes back without loss.
struct SubdividedSurface {
  SubdivisionLevels levels;
  Eigen::Matrix3Xd places_mm;  ///< of the finest level's vertices
  DomainMesh on_domain;        ///< the finest level as drawn there

  TriangleMesh mesh() const;  ///< of the finest level, without a name
};

/// `base` is drawn on the same domain as the surface (`drawn`, of spread_over_domain()); the edges of the finer levels
/// are halved on the domain. Torus: base edges are shorter than half a period.
SubdividedSurface subdivided(const TriangleMesh& surface, const DomainMesh& drawn, const DomainMesh& base, int levels);

/// Details of each step, [k] from level k to k + 1: 3 × new vertices, mm.
std::vector<Eigen::Matrix3Xd> details_of(const SubdividedSurface& surface);
/// The finest places from those of level 0 and the details.
Eigen::Matrix3Xd with_details(const SubdivisionLevels& levels, const Eigen::Matrix3Xd& base_mm,
                              const std::vector<Eigen::Matrix3Xd>& details);

/// Distances of the surface's vertices to the finest level's mesh, mm.
struct SurfaceFit {
  double mean_mm = 0, largest_mm = 0;
};
SurfaceFit fit_of(const SubdividedSurface& subdivided, const TriangleMesh& surface);

}  // namespace isostack
