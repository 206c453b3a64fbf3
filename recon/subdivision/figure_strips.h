#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/subdivision/simplicial_mesh.h"

namespace isostack {

/// A closed chain of base vertices at one t, the inside to the left.
struct VertexRing {
  std::vector<int> vertices;
  bool is_hole = false;
};

/// Base vertices that an edge, or a chain of them, is to join.
struct JoinedVertices {
  int lower = 0, upper = 0;
};

/// The triangles of an interpolator of figures while they are made.
class FigureStrips {
 public:
  int add_vertex(const Eigen::Vector2d& place_mm, double t_mm);

  /// Between all rings of one t and all of the next. Rings that belong together (of one kind, near, of like size;
  /// with joined vertices for certain) are joined; see figure_interpolator() for the rest. Throws InputError when the
  /// ways between joined vertices cross, or lead from one kind to the other.
  void join(const std::vector<VertexRing>& lower, const std::vector<VertexRing>& upper,
            const std::vector<JoinedVertices>& joined);

  SimplicialMesh mesh() const;

 private:
  struct Group;
  std::vector<Group> groups(const std::vector<VertexRing>& lower, const std::vector<VertexRing>& upper,
                            const std::vector<JoinedVertices>& joined) const;
  double unlikeness(const VertexRing& a, const VertexRing& b) const;
  double gap_mm(const VertexRing& a, const VertexRing& b) const;
  Eigen::Vector2d place(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)].head<2>(); }
  double time(const VertexRing& ring) const { return vertices_[static_cast<std::size_t>(ring.vertices[0])].z(); }
  std::vector<Eigen::Vector2d> places(const VertexRing& ring) const;
  void tile(const VertexRing& lower, const VertexRing& upper, const std::vector<JoinedVertices>& joined);
  void cap(const VertexRing& ring, double t_mm, bool dies);
  /// Ties the rings of the side that has more together, half-way.
  void tie(const Group& group, const std::vector<JoinedVertices>& joined);

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Eigen::Vector3i> triangles_;
};

}  // namespace isostack
