#pragma once

#include <memory>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/subdivision/surface_domain.h"

namespace isostack {

struct SurfaceMapOptions {
  int sweeps = 3;         ///< over all vertices, each time there are a quarter more
  int final_sweeps = 20;  ///< over all vertices, at the end
};

/// A closed surface drawn on the domain of its genus, triangle by triangle, one to one: no triangle is turned over, so
/// each point of the domain is one point of the surface and the other way round.
///
/// The paper asks for MAPS (Lee et al. 1998): vertices are taken away, each into the flattened ring round it, until a
/// base mesh is left, which is the domain. Here vertices are taken away to the very end and come back coarse to fine,
/// each to where its stretch is least (Praun & Hoppe 2003): the domain is smooth, without the base mesh's creases,
/// sampling it is even on the surface, also on fingers, and two surfaces of one genus share it, which makes the base
/// tetrahedra between any two base meshes.
DomainMesh spread_over_domain(const TriangleMesh& mesh, const SurfaceMapOptions& options = {},
                              const Progress& progress = {});

/// Of a closed mesh in one part. Throws InputError naming the mesh when it is not closed, or in several parts.
int genus_of(const TriangleMesh& mesh);

/// Where a point of the domain is on the surface.
struct SurfacePlace {
  int triangle = 0;
  Eigen::Vector3d shares = Eigen::Vector3d::Zero();  ///< of its corners, sum 1
};

/// Finds triangles by walking to them. Not for several threads at once: it remembers where it was.
class DomainWalk {
 public:
  /// `drawn` is referred to.
  explicit DomainWalk(const DomainMesh& drawn);
  /// The nearest triangle where rounding leaves a gap.
  SurfacePlace find(const Eigen::Vector3d& point);
  /// The triangle across the edge opposite a corner.
  int beside(int triangle, int corner) const { return (*beside_)[static_cast<std::size_t>(triangle)][corner]; }

 private:
  void cross(int side, Eigen::Vector3d& point);
  SurfacePlace nearest(const Eigen::Vector3d& point);

  const DomainMesh& drawn_;
  /// Each triangle: the one across the edge opposite each corner. Copies of a walk share it.
  std::shared_ptr<const std::vector<Eigen::Vector3i>> beside_;
  int last_ = 0;
  unsigned chance_ = 1;
};

}  // namespace isostack
