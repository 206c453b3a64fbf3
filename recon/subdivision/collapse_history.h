#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// One vertex that was taken away by moving it along an edge onto a neighbour; read backwards, a vertex split.
struct VertexSplit {
  int kept, gone;
  std::vector<int> moved;                         ///< triangles that had `gone` and have `kept` instead
  std::array<int, 2> flattened;                   ///< triangles that had both, and vanished
  std::array<Eigen::Vector3i, 2> flattened_were;  ///< their corners
};

/// A closed surface made coarse until no edge can be collapsed any more: a tetrahedron for genus 0, at most ten
/// vertices for genus 1 (Barnette 1982; Lavrenchenko 1990), always. Vertices and triangles keep their numbers.
struct CollapseHistory {
  std::vector<Eigen::Vector3i> coarse;  ///< triangles by number; those that vanished have corners −1
  std::vector<VertexSplit> splits;      ///< in the order of their collapses: the last is to be undone first
};

/// Vertices go in the order of the quadric error (Garland & Heckbert 1997) of the surface without them, so that tips
/// stay long. Throws GeometryError when the mesh is not a closed 2-manifold.
CollapseHistory collapsed(const TriangleMesh& mesh);

}  // namespace isostack
