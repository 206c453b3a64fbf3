#include "recon/distance/mesh_inside.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "recon/distance/winding_number.h"
#include "recon/metrics/voxelize.h"

namespace isostack {

namespace {

/// +1 when the side runs from the edge's lower vertex to the higher.
int direction_of(const TriangleMesh& mesh, int side) {
  return corner(mesh, side / 3, side % 3) < corner(mesh, side / 3, side % 3 + 1) ? 1 : -1;
}

struct Flaws {
  int rims = 0;     ///< edges with an odd number of triangles
  int flipped = 0;  ///< edges with two triangles that disagree about the outside
};

Flaws flaws_of(const TriangleMesh& mesh, const MeshTopology& topology) {
  Flaws flaws;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const std::span<const int> sides = topology.sides_of_edge[static_cast<int>(e)];
    if (sides.size() % 2 != 0) ++flaws.rims;
    if (sides.size() == 2 && direction_of(mesh, sides[0]) == direction_of(mesh, sides[1])) ++flaws.flipped;
  }
  return flaws;
}

/// The edge numbers of a triangle's sides; -1 for a side of no length.
std::vector<int> edges_of_sides(const TriangleMesh& mesh, const MeshTopology& topology) {
  std::vector<int> edges(3 * mesh.triangles.size(), -1);
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
    for (const int side : topology.sides_of_edge[static_cast<int>(e)])
      edges[static_cast<std::size_t>(side)] = static_cast<int>(e);
  return edges;
}

double area_of(const TriangleMesh& mesh, int triangle) {
  const Eigen::Vector3d& a = vertex_mm(mesh, corner(mesh, triangle, 0));
  return 0.5 *
         (vertex_mm(mesh, corner(mesh, triangle, 1)) - a).cross(vertex_mm(mesh, corner(mesh, triangle, 2)) - a).norm();
}

/// Triangles that share an edge of two turned alike; in every piece the orientation of most of the area stays.
TriangleMesh turned_alike(const TriangleMesh& mesh, const MeshTopology& topology) {
  const std::vector<int> edge_of_side = edges_of_sides(mesh, topology);
  std::vector<int> turn(mesh.triangles.size(), 0);
  TriangleMesh result = mesh;
  for (std::size_t seed = 0; seed < turn.size(); ++seed) {
    if (turn[seed] != 0) continue;
    std::vector<int> piece{static_cast<int>(seed)};
    turn[seed] = 1;
    double kept = 0;
    for (std::size_t n = 0; n < piece.size(); ++n) {
      const int triangle = piece[n], turned = turn[static_cast<std::size_t>(triangle)];
      kept += turned * area_of(mesh, triangle);
      for (int side = 3 * triangle; side < 3 * triangle + 3; ++side) {
        const int edge = edge_of_side[static_cast<std::size_t>(side)];
        if (edge < 0 || topology.sides_of_edge[edge].size() != 2) continue;
        const int other = topology.sides_of_edge[edge][topology.sides_of_edge[edge][0] == side ? 1 : 0];
        int& turn_there = turn[static_cast<std::size_t>(other / 3)];
        if (turn_there != 0) continue;
        turn_there = direction_of(mesh, side) == direction_of(mesh, other) ? -turned : turned;
        piece.push_back(other / 3);
      }
    }
    for (const int triangle : piece)
      if (turn[static_cast<std::size_t>(triangle)] * (kept < 0 ? -1 : 1) < 0) {
        Eigen::Vector3i& t = result.triangles[static_cast<std::size_t>(triangle)];
        std::swap(t[1], t[2]);
      }
  }
  return result;
}

/// Cells of so many voxels each way.
constexpr int cell_voxels = 4;

/// Which cells a triangle's box touches.
Volume<std::uint8_t> touched_cells(const TriangleMesh& mesh, const Grid& grid) {
  Grid cells;
  cells.size = grid.size.array() / cell_voxels + 1;
  Volume<std::uint8_t> touched(cells);
  const Eigen::Affine3d world_to_index = grid.index_to_world.inverse();
  for (const Eigen::Vector3i& t : mesh.triangles) {
    Eigen::AlignedBox3d box;
    for (const int v : t) box.extend(world_to_index * vertex_mm(mesh, v));
    const auto cell_at = [&](const Eigen::Vector3d& index) -> Eigen::Vector3i {
      const Eigen::Array3d last = (cells.size.array() - 1).cast<double>();
      return (index.array() / cell_voxels).floor().max(0.0).min(last).cast<int>();
    };
    const Eigen::Vector3i low = cell_at(box.min()), high = cell_at(box.max());
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i) touched.at(i, j, k) = 1;
  }
  return touched;
}

/// The number is harmonic away from the triangles, so that it has its extremes at a cell's border where there are none:
/// such cells go by their corners when these are clear.
void mark_by_winding(const TriangleMesh& mesh, const Grid& grid, std::vector<std::uint8_t>& inside) {
  constexpr double clear = 0.25;
  const WindingNumber winding(mesh);
  const Volume<std::uint8_t> touched = touched_cells(mesh, grid);
  const auto times_at = [&](int i, int j, int k) {
    return std::abs(winding.at(grid.index_to_world * Eigen::Vector3d(i, j, k)));
  };
  tbb::parallel_for(0, touched.grid.size.z() * touched.grid.size.y(), [&](int row) {
    const int cell_j = row % touched.grid.size.y(), cell_k = row / touched.grid.size.y();
    for (int cell_i = 0; cell_i < touched.grid.size.x(); ++cell_i) {
      const Eigen::Vector3i first = cell_voxels * Eigen::Vector3i(cell_i, cell_j, cell_k);
      const Eigen::Vector3i end = (first.array() + cell_voxels).min(grid.size.array());
      if (first.x() >= end.x() || first.y() >= end.y() || first.z() >= end.z()) continue;
      double low = std::numeric_limits<double>::infinity(), high = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const double times = times_at(corner & 1 ? end.x() : first.x(), corner & 2 ? end.y() : first.y(),
                                      corner & 4 ? end.z() : first.z());
        low = std::min(low, times);
        high = std::max(high, times);
      }
      const bool is_even = touched.at(cell_i, cell_j, cell_k) == 0 && (high < clear || low > 1 - clear);
      for (int k = first.z(); k < end.z(); ++k)
        for (int j = first.y(); j < end.y(); ++j)
          for (int i = first.x(); i < end.x(); ++i)
            inside[grid.offset(i, j, k)] = (is_even ? high : times_at(i, j, k)) > 0.5 ? 1 : 0;
    }
  });
}

}  // namespace

MeshInside inside_of(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid, MeshSign sign) {
  const Flaws flaws = flaws_of(mesh, topology);
  MeshInside result;
  result.closed = flaws.rims == 0;
  if (flaws.flipped > 0)
    result.remarks.push_back(fmt::format(
        "at {} edges the triangles disagree about the outside; the orientation was not relied on", flaws.flipped));
  if (result.closed && sign == MeshSign::by_crossings) {
    LabelVolume labels(grid);
    voxelize(mesh, 1, labels);
    result.inside.assign(labels.voxels.begin(), labels.voxels.end());
    return result;
  }
  if (!result.closed)
    result.remarks.push_back(fmt::format(
        "the mesh is not closed ({} edges at holes); inside is where its generalised winding number is beyond 1/2",
        flaws.rims));
  result.inside.resize(grid.voxel_count());
  mark_by_winding(turned_alike(mesh, topology), grid, result.inside);
  return result;
}

}  // namespace isostack
