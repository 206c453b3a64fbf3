#include "recon/metrics/voxelize.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace isostack {

namespace {

using Eigen::Vector3d;

/// Twice the signed area of (a, b, p) in the (y, z) plane, computed so that swapping a and b
/// changes exactly the sign: two triangles that share an edge then agree on which side p is.
double side_of_edge(const Vector3d& a, const Vector3d& b, int index_a, int index_b, double y, double z) {
  const bool ordered = index_a < index_b;
  const Vector3d& low = ordered ? a : b;
  const Vector3d& high = ordered ? b : a;
  const double area = (high.y() - low.y()) * (z - low.z()) - (high.z() - low.z()) * (y - low.y());
  return ordered ? area : -area;
}

/// Crossings of the mesh with the row lines of one k-plane.
struct RowCrossing {
  int row;
  double x;         ///< in index units
  bool faces_back;  ///< the triangle's normal points towards smaller x: rows enter there (right-handed grids)
};

// Centres are shifted by an irrational fraction of a voxel so that no line passes through a vertex and a
// face through voxel centres has them on one side, the same for both meshes it may belong to.
constexpr double shift_x = 1.4142136e-7, shift_y = 1.2360679e-7, shift_z = 1.7320508e-7;

void add_crossings(const Vector3d corner[3], const Eigen::Vector3i& t, double z, int rows,
                   std::vector<RowCrossing>& crossings) {
  const double low_y = std::min({corner[0].y(), corner[1].y(), corner[2].y()});
  const double high_y = std::max({corner[0].y(), corner[1].y(), corner[2].y()});
  const int first = std::max(0, static_cast<int>(std::ceil(low_y - shift_y)));
  const int last = std::min(rows - 1, static_cast<int>(std::floor(high_y - shift_y)));
  for (int row = first; row <= last; ++row) {
    const double y = row + shift_y;
    const double w0 = side_of_edge(corner[1], corner[2], t[1], t[2], y, z);
    const double w1 = side_of_edge(corner[2], corner[0], t[2], t[0], y, z);
    const double w2 = side_of_edge(corner[0], corner[1], t[0], t[1], y, z);
    const bool within = (w0 > 0 && w1 > 0 && w2 > 0) || (w0 < 0 && w1 < 0 && w2 < 0);
    if (within)
      crossings.push_back(
          {row, (w0 * corner[0].x() + w1 * corner[1].x() + w2 * corner[2].x()) / (w0 + w1 + w2), w0 < 0});
  }
}

void fill_rows(const std::vector<RowCrossing>& crossings, int k, std::uint16_t label, LabelVolume& labels) {
  const int columns = labels.grid.size.x();
  for (std::size_t c = 0; c + 1 < crossings.size(); c += 2) {
    if (crossings[c].row != crossings[c + 1].row) {  // an open mesh: skip the unpaired crossing
      --c;
      continue;
    }
    const int first = std::max(0, static_cast<int>(std::ceil(crossings[c].x - shift_x)));
    const int last = std::min(columns - 1, static_cast<int>(std::floor(crossings[c + 1].x - shift_x)));
    for (int i = first; i <= last; ++i) labels.at(i, crossings[c].row, k) = label;
  }
}

/// visit(k, crossings) for every k-plane, crossings by row and along it; planes in parallel.
template <class Visit>
void for_each_plane(const TriangleMesh& mesh, const Grid& grid, Visit visit) {
  const Eigen::Affine3d world_to_index = grid.index_to_world.inverse();
  std::vector<Vector3d> corners(mesh.vertices_mm.size());
  for (std::size_t v = 0; v < corners.size(); ++v) corners[v] = world_to_index * mesh.vertices_mm[v];

  const int planes = grid.size.z();
  std::vector<std::vector<std::size_t>> triangles_of_plane(static_cast<std::size_t>(planes));
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    double low = INFINITY, high = -INFINITY;
    for (const int v : mesh.triangles[n]) {
      low = std::min(low, corners[static_cast<std::size_t>(v)].z());
      high = std::max(high, corners[static_cast<std::size_t>(v)].z());
    }
    const int first = std::max(0, static_cast<int>(std::ceil(low - shift_z)));
    const int last = std::min(planes - 1, static_cast<int>(std::floor(high - shift_z)));
    for (int k = first; k <= last; ++k) triangles_of_plane[static_cast<std::size_t>(k)].push_back(n);
  }
  tbb::parallel_for(0, planes, [&](int k) {
    std::vector<RowCrossing> crossings;
    for (const std::size_t n : triangles_of_plane[static_cast<std::size_t>(k)]) {
      const Eigen::Vector3i& t = mesh.triangles[n];
      const Vector3d corner[3] = {corners[static_cast<std::size_t>(t[0])], corners[static_cast<std::size_t>(t[1])],
                                  corners[static_cast<std::size_t>(t[2])]};
      add_crossings(corner, t, k + shift_z, grid.size.y(), crossings);
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const RowCrossing& a, const RowCrossing& b) { return a.row != b.row ? a.row < b.row : a.x < b.x; });
    visit(k, crossings);
  });
}

/// The middle of the first stretch of a row, longer than a voxel, that is not enclosed once or not at all.
std::optional<Vector3d> doubly_enclosed_in(const std::vector<RowCrossing>& crossings, int k, bool is_right_handed) {
  constexpr double least_voxels = 1;
  int times = 0;
  for (std::size_t c = 0; c + 1 < crossings.size(); ++c) {
    times += crossings[c].faces_back == is_right_handed ? 1 : -1;
    if (crossings[c].row != crossings[c + 1].row) {
      times = 0;
      continue;
    }
    if ((times < 0 || times > 1) && crossings[c + 1].x - crossings[c].x > least_voxels)
      return Vector3d(0.5 * (crossings[c].x + crossings[c + 1].x), crossings[c].row, k);
  }
  return std::nullopt;
}

}  // namespace

void voxelize(const TriangleMesh& mesh, std::uint16_t label, LabelVolume& labels) {
  for_each_plane(mesh, labels.grid,
                 [&](int k, const std::vector<RowCrossing>& crossings) { fill_rows(crossings, k, label, labels); });
}

std::optional<Vector3d> doubly_enclosed(const TriangleMesh& mesh, const Grid& grid) {
  std::vector<std::optional<Vector3d>> found(static_cast<std::size_t>(grid.size.z()));
  const bool is_right_handed = grid.index_to_world.linear().determinant() > 0;
  for_each_plane(mesh, grid, [&](int k, const std::vector<RowCrossing>& crossings) {
    found[static_cast<std::size_t>(k)] = doubly_enclosed_in(crossings, k, is_right_handed);
  });
  for (const auto& place : found)
    if (place) return grid.index_to_world * *place;
  return std::nullopt;
}

}  // namespace isostack
