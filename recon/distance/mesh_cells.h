#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "recon/distance/convex_cell.h"
#include "recon/distance/mesh_topology.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// The cells of the characteristics (Breen et al. 2001, §4.1): for every face, edge and vertex a polyhedron that holds
/// all points nearest to it and no farther than the band. Elements are numbered: faces, then edges, then vertices.
class MeshCells {
 public:
  /// All three must outlive this.
  MeshCells(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid, double band_mm);

  int count() const { return vertex(static_cast<int>(mesh_.vertices_mm.size())); }
  bool is_face(int element) const { return element < faces_; }
  bool is_edge(int element) const { return element >= faces_ && element < vertex(0); }
  int edge_of(int element) const { return element - faces_; }
  int vertex_of(int element) const { return element - vertex(0); }
  /// The face itself, or one at the edge or vertex.
  int triangle_of(int element) const;

  /// The k-planes that the element's part of the band reaches, at most.
  Eigen::Vector2d reach_in_k(int element) const;
  /// The cell in index coordinates of the grid; empty when nothing is nearest to the element.
  void make(int element, ConvexCell& cell) const;

 private:
  int vertex(int number) const { return faces_ + static_cast<int>(topology_.edges.size()) + number; }
  const Eigen::Vector3d& in_grid(int vertex) const { return vertices_in_grid_[static_cast<std::size_t>(vertex)]; }
  void make_prism(int triangle, ConvexCell& cell) const;
  void make_wedge(int edge, ConvexCell& cell) const;
  void make_cone(int vertex, ConvexCell& cell) const;

  const TriangleMesh& mesh_;
  const MeshTopology& topology_;
  double band_mm_;
  int faces_;
  Eigen::Affine3d world_to_index_;
  double band_in_k_;
  std::vector<Eigen::Vector3d> vertices_in_grid_;
};

/// How far points are from one element of a mesh, which is worked out once.
class ElementDistance {
 public:
  ElementDistance(const TriangleMesh& mesh, const MeshTopology& topology, const MeshCells& cells, int element);
  double squared_mm2(const Eigen::Vector3d& point_mm) const;

 private:
  enum class Kind { face, edge, vertex } kind_ = Kind::vertex;
  Eigen::Vector3d a_, ab_, ac_, normal_;
  double d00_ = 0, d01_ = 0, d11_ = 0, inverse_ = 0;
};

}  // namespace isostack
