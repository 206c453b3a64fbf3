#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

namespace isostack {

/// A triangle cut up so that points within it, or on its sides, are corners, and edges that are asked for are edges.
/// Corners 0, 1, 2 are the triangle's, counter-clockwise; points are numbered on. Made for few points.
class FaceTriangulation {
 public:
  explicit FaceTriangulation(const std::array<Eigen::Vector2d, 3>& corners);

  /// Inside; returns its number. Points that numbers put outside are drawn in.
  int add_inside(const Eigen::Vector2d& point);
  /// On the side from corner `side` to the next.
  int add_on_side(int side, const Eigen::Vector2d& point);
  /// Makes a and b the ends of an edge, unless a point or another such edge is in the way.
  void join(int a, int b);
  /// Turns edges that were not asked for until the triangles are Delaunay's: well before and after edges are joined.
  void make_delaunay();

  const std::vector<Eigen::Vector3i>& triangles() const { return triangles_; }

 private:
  using Edge = std::pair<int, int>;
  double area(int a, int b, int c) const;
  bool has_edge(int a, int b) const;
  /// The two triangles of an inner edge and the corners opposite; −1 on a side.
  struct Pair {
    int left = -1, right = -1, left_corner = -1, right_corner = -1;
  };
  Pair pair_at(int a, int b) const;
  bool flip(int a, int b);

  std::vector<Eigen::Vector2d> points_;
  std::vector<int> side_of_;  ///< of points on sides: which; −1 inside
  std::vector<Eigen::Vector3i> triangles_;
  std::vector<Edge> kept_;
};

}  // namespace isostack
