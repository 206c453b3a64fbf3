#pragma once

#include <vector>

#include "recon/geometry/triangle_mesh.h"
#include "recon/subdivision/collapse_history.h"
#include "recon/subdivision/stretch.h"
#include "recon/subdivision/surface_domain.h"

namespace isostack {

/// A coarse surface on its domain, to which vertices come back one by one, each to where all its triangles are seen
/// from (Praun & Hoppe 2003, Section 4). No triangle is ever turned over.
class DomainGrowth {
 public:
  /// `start`: the coarse triangles, drawn; those that vanished have corners −1. `mesh` is referred to.
  DomainGrowth(const TriangleMesh& mesh, DomainMesh start);

  /// Undoes a collapse. Throws SolveError when the vertex finds no place (triangles too thin for numbers).
  void undo(const VertexSplit& split);
  /// Moves a vertex to where the triangles round it stretch least.
  void relax(int vertex);
  /// The same for it and its neighbours.
  void relax_round(int vertex);
  /// The same for all vertices, in the order of their numbers.
  void sweep();
  /// Sum over the triangles.
  double total_stretch() const;
  /// Torus: the shape of the same area that stretches least (closed form: the metric is S⁻¹, S summed over triangles).
  void reshape();
  void pin(int vertex) { pinned_[at(vertex)] = true; }
  /// Moves all vertices at once, pinned ones too, unless that turned a triangle over (false).
  bool displace(std::vector<Eigen::Vector3d> positions);

  const Eigen::Vector3d& position(int vertex) const { return drawn_.positions[at(vertex)]; }
  /// Corners in the order of the mesh's.
  DomainMesh drawn() const;

 private:
  struct Side {
    const SurfaceTriangle* triangle;
    Eigen::Vector3d q, r;
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int number_of(int vertex, int triangle) const;
  void collect_star(int vertex);
  bool is_seen_from(const Eigen::Vector3d& p) const;
  double star_stretch(const Eigen::Vector3d& p) const;
  Eigen::Vector2d star_gradient(const Eigen::Vector3d& p, const Eigen::Matrix<double, 3, 2>& axes) const;
  void restore_triangles(const VertexSplit& split);
  void place(const VertexSplit& split);
  void measure(int triangle);

  const TriangleMesh& mesh_;
  double least_squared_mm2_ = 0;  ///< see surface_triangle()
  DomainMesh drawn_;
  std::vector<SurfaceTriangle> surface_;
  std::vector<std::vector<int>> around_;
  std::vector<bool> pinned_;
  std::vector<Side> star_;  ///< of the vertex in work
};

}  // namespace isostack
