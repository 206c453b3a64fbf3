#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <vector>

#include "recon/geometry/triangle_mesh.h"
#include "recon/subdivision/surface_domain.h"

namespace isostack {

/// A surface and a mesh that samples it (the finest level), drawn over each other on their domain: where the surface's
/// vertices lie in the mesh's triangles, and its edges cross the mesh's.
struct SurfaceOverlay {
  /// One of the mesh's own vertices, or an added one.
  struct Node {
    bool is_added = false;
    int number = 0;
  };
  struct Added {
    Eigen::Vector3d place_mm;
    Eigen::Vector3d shares;  ///< inside a triangle: of its corners; on an edge (low, high): of high, and 0, 0
  };
  std::vector<Added> added;
  std::map<int, std::vector<int>> inside;                  ///< a triangle: added nodes
  std::map<std::array<int, 2>, std::vector<int>> on_edge;  ///< an edge (low, high): added nodes, in order
  std::map<int, std::vector<std::array<Node, 2>>> pieces;  ///< a triangle: pieces of the surface's edges
  std::map<int, Eigen::Vector3d> met;                      ///< vertices of the mesh that are the surface's: places
};

/// An edge whose way numbers lose is left out: any part of an overlay cuts triangles up consistently.
SurfaceOverlay surface_overlay(const TriangleMesh& surface, const DomainMesh& drawn, const DomainMesh& mesh);

}  // namespace isostack
