#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// A triangle mesh whose edges can be split, collapsed and flipped. None of these changes how many parts, handles and
/// borders it has: a collapse is allowed only where the link condition holds (Dey et al. 1999). Borders, and vertices
/// where two sheets touch in a point, stay exactly as they are. Numbers of vertices and triangles stay valid; removed
/// triangles are left as gaps.
class EditableMesh {
 public:
  /// Both triangles of an edge a → b: `opposite[0]` is the third corner where the edge runs from a to b, `[1]` where
  /// it runs back; −1 at a border.
  struct Sides {
    std::array<int, 2> triangles{-1, -1}, opposite{-1, -1};
    bool is_border() const { return triangles[0] < 0 || triangles[1] < 0; }
  };

  /// Throws GeometryError when edges have more than two triangles, or two that disagree about the outside, or
  /// triangles that repeat a vertex.
  explicit EditableMesh(const TriangleMesh& mesh);
  /// The mesh without gaps and without normals.
  TriangleMesh compact() const;

  int vertex_slots() const { return static_cast<int>(positions_.size()); }
  int triangle_slots() const { return static_cast<int>(triangles_.size()); }
  std::size_t triangle_count() const { return triangle_count_; }
  bool has_vertex(int v) const { return !around_[at(v)].empty(); }
  bool has_triangle(int t) const { return triangles_[at(t)][0] >= 0; }
  const Eigen::Vector3i& triangle(int t) const { return triangles_[at(t)]; }
  const Eigen::Vector3d& position(int v) const { return positions_[at(v)]; }
  const std::vector<int>& triangles_at(int v) const { return around_[at(v)]; }
  /// On a border, or where sheets touch: it keeps its place.
  bool is_fixed(int v) const { return fixed_[at(v)]; }

  std::vector<int> neighbours(int v) const;
  Sides sides(int a, int b) const;
  double length(int a, int b) const { return (position(a) - position(b)).norm(); }
  /// Twice its area long, outwards.
  Eigen::Vector3d area_normal(int t) const;
  /// At the corner v of the triangle, radians.
  double angle_at(int t, int v) const;
  /// Unit, weighted by area.
  Eigen::Vector3d vertex_normal(int v) const;

  /// Whether triangles at v, apart from those that also have `except`, keep their direction within the angle of this
  /// cosine when v moves there.
  bool keeps_directions(int v, const Eigen::Vector3d& there, double least_cosine, int except = -1) const;

  void move(int v, const Eigen::Vector3d& there) { positions_[at(v)] = there; }
  /// The new vertex, in the edge's middle. Not for borders.
  int split(int a, int b);
  /// Whether `gone` can become one with `keep` (which only stays where it is when it is fixed).
  bool may_collapse(int keep, int gone) const;
  void collapse(int keep, int gone, const Eigen::Vector3d& there);
  bool may_flip(int a, int b) const;
  void flip(int a, int b);

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  bool are_neighbours(int a, int b) const;
  bool is_sliver(int t) const;
  void find_fixed();
  void replace_corner(int t, int from, int to);
  void leave(int v, int t);

  TriangleMesh shell_;  ///< name and colour
  std::vector<Eigen::Vector3d> positions_;
  std::vector<Eigen::Vector3i> triangles_;
  std::vector<std::vector<int>> around_;  ///< triangles at each vertex
  std::vector<bool> fixed_;
  std::size_t triangle_count_ = 0;
};

}  // namespace isostack
