#include "recon/metrics/voxel_surface.h"

#include <array>
#include <cstdint>
#include <unordered_map>

#include "recon/geometry/disjoint_sets.h"

namespace isostack {

namespace {

using Eigen::Vector3i;

/// One voxel's face towards the outside; corners in the lattice of voxel corners, (i, j, k) being the corner
/// before voxel (i, j, k), counter-clockwise seen from outside in index space.
struct Face {
  std::size_t voxel;
  std::array<Vector3i, 4> corners;
};

class VoxelFaces {
 public:
  explicit VoxelFaces(const LabelVolume& labels) : labels_(labels) {
    const Vector3i size = labels.grid.size;
    for (int k = 0; k < size.z(); ++k)
      for (int j = 0; j < size.y(); ++j)
        for (int i = 0; i < size.x(); ++i)
          if (labels.at(i, j, k) != 0) add_faces_of({i, j, k});
  }
  const std::vector<Face>& faces() const { return faces_; }

 private:
  bool is_inside(const Vector3i& v) const {
    return (v.array() >= 0).all() && (v.array() < labels_.grid.size.array()).all() &&
           labels_.at(v.x(), v.y(), v.z()) != 0;
  }

  void add_faces_of(const Vector3i& voxel) {
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        const Vector3i step = Vector3i::Unit(axis) * (side == 1 ? 1 : -1);
        if (is_inside(voxel + step)) continue;
        const Vector3i base = voxel + Vector3i::Unit(axis) * side;
        const Vector3i u = Vector3i::Unit((axis + (side == 1 ? 1 : 2)) % 3);
        const Vector3i v = Vector3i::Unit((axis + (side == 1 ? 2 : 1)) % 3);
        faces_.push_back(
            {labels_.grid.offset(voxel.x(), voxel.y(), voxel.z()), {base, base + u, base + u + v, base + v}});
      }
  }

  const LabelVolume& labels_;
  std::vector<Face> faces_;
};

/// An edge of the lattice of corners: its lower end and its axis.
std::uint64_t edge_key(const Vector3i& a, const Vector3i& b, const Vector3i& size) {
  const Vector3i low = a.cwiseMin(b);
  const int axis = a.x() != b.x() ? 0 : a.y() != b.y() ? 1 : 2;
  const auto nx = static_cast<std::uint64_t>(size.x() + 1), ny = static_cast<std::uint64_t>(size.y() + 1);
  const auto x = static_cast<std::uint64_t>(low.x()), y = static_cast<std::uint64_t>(low.y()),
             z = static_cast<std::uint64_t>(low.z());
  return ((z * ny + y) * nx + x) * 3 + static_cast<std::uint64_t>(axis);
}

/// The faces at one edge, as 4 · face + the number of the edge in it: two, or four where two voxels touch diagonally.
struct FacesAtEdge {
  std::array<std::size_t, 4> sides;
  int count = 0;
};

void join_across(std::size_t a, std::size_t b, DisjointSets& sets) {
  const auto next = [](std::size_t side) { return side / 4 * 4 + (side + 1) % 4; };
  sets.join(a, next(b));  // neighbours run along their common edge in opposite directions
  sets.join(next(a), b);
}

/// Corners of faces are one vertex when they are joined through shared edges.
void join_corners(const std::vector<Face>& faces, const Vector3i& size, DisjointSets& sets) {
  std::unordered_map<std::uint64_t, FacesAtEdge> edges;
  edges.reserve(faces.size() * 2);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t e = 0; e < 4; ++e) {
      FacesAtEdge& at_edge = edges[edge_key(faces[f].corners[e], faces[f].corners[(e + 1) % 4], size)];
      at_edge.sides[static_cast<std::size_t>(at_edge.count++)] = 4 * f + e;
    }
  for (const auto& [key, at_edge] : edges) {
    if (at_edge.count == 2) {
      join_across(at_edge.sides[0], at_edge.sides[1], sets);
      continue;
    }
    for (std::size_t a = 0; a < 4; ++a)  // a diagonal touch: each voxel keeps its own two faces together
      for (std::size_t b = a + 1; b < 4; ++b)
        if (faces[at_edge.sides[a] / 4].voxel == faces[at_edge.sides[b] / 4].voxel)
          join_across(at_edge.sides[a], at_edge.sides[b], sets);
  }
}

}  // namespace

TriangleMesh voxel_surface(const LabelVolume& labels) {
  const VoxelFaces all(labels);
  const std::vector<Face>& faces = all.faces();
  DisjointSets sets(4 * faces.size());
  join_corners(faces, labels.grid.size, sets);
  const bool mirrored = labels.grid.index_to_world.linear().determinant() < 0;
  TriangleMesh mesh;
  mesh.name = "labels";
  std::vector<int> vertex_of(4 * faces.size(), -1);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::array<int, 4> corner{};
    for (std::size_t c = 0; c < 4; ++c) {
      int& vertex = vertex_of[sets.root(4 * f + c)];
      if (vertex < 0) {
        vertex = static_cast<int>(mesh.vertices_mm.size());
        mesh.vertices_mm.emplace_back(labels.grid.index_to_world *
                                      (faces[f].corners[c].cast<double>().array() - 0.5).matrix());
      }
      corner[c] = vertex;
    }
    if (mirrored) std::swap(corner[1], corner[3]);
    mesh.triangles.emplace_back(corner[0], corner[1], corner[2]);
    mesh.triangles.emplace_back(corner[0], corner[2], corner[3]);
  }
  return mesh;
}

}  // namespace isostack
