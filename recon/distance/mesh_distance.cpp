#include "recon/distance/mesh_distance.h"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <limits>

#include "recon/distance/band_scan.h"
#include "recon/distance/carry_outwards.h"
#include "recon/distance/mesh_inside.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/point_triangle.h"

namespace isostack {

namespace {

using Eigen::Vector3d;

void require_usable(const TriangleMesh& mesh) {
  const std::string where = mesh.name.empty() ? "mesh" : mesh.name;
  if (mesh.triangles.empty()) throw InputError(where, "it has no triangles", "give a closed surface");
  const int vertices = static_cast<int>(mesh.vertices_mm.size());
  for (const Eigen::Vector3i& t : mesh.triangles)
    if (t.minCoeff() < 0 || t.maxCoeff() >= vertices)
      throw InputError(where, "a triangle names a vertex that does not exist", "repair the mesh");
  for (const Vector3d& v : mesh.vertices_mm)
    if (!v.allFinite()) throw InputError(where, "a vertex is not finite", "repair the mesh");
}

/// Where the surface does not come near the grid: the triangle nearest to the first voxel, to start from.
void seed_first_voxel(const TriangleMesh& mesh, const Grid& grid, CarriedDistances& known) {
  const Vector3d point = grid.index_to_world.translation();
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto mm = static_cast<float>((closest_point_on_triangle(triangle_of(mesh, t), point) - point).norm());
    if (mm < known.mm.front()) known.mm.front() = mm, known.triangle.front() = t;
  }
}

MeshElement described(int element, const MeshCells& cells, const MeshTopology& topology) {
  if (cells.is_face(element)) return {MeshElement::Kind::face, element};
  if (cells.is_edge(element)) return {MeshElement::Kind::edge, topology.sides_of_edge[cells.edge_of(element)].front()};
  return {MeshElement::Kind::vertex, cells.vertex_of(element)};
}

/// Writes what is closest to each voxel; `elements` counts within the band, the carried triangles beyond.
void keep_closest(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid, const MeshCells& cells,
                  const std::vector<int>& elements, const CarriedDistances& known, MeshDistance& result) {
  result.closest_points_mm.assign(known.mm.size(), Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  result.closest_elements.resize(known.mm.size());
  tbb::parallel_for(0, grid.size.z() * grid.size.y(), [&](int row) {
    const int j = row % grid.size.y(), k = row / grid.size.y();
    for (int i = 0; i < grid.size.x(); ++i) {
      const std::size_t voxel = grid.offset(i, j, k);
      if (known.triangle[voxel] < 0) continue;
      result.closest_points_mm[voxel] =
          closest_point_on_triangle(triangle_of(mesh, known.triangle[voxel]), grid.index_to_world * Vector3d(i, j, k));
      result.closest_elements[voxel] = elements[voxel] >= 0
                                           ? described(elements[voxel], cells, topology)
                                           : MeshElement{MeshElement::Kind::face, known.triangle[voxel]};
    }
  });
}

void set_signed(const CarriedDistances& known, const std::vector<std::uint8_t>& inside, double band_mm,
                Volume<float>& distance_mm) {
  tbb::parallel_for(std::size_t{0}, known.mm.size(), [&](std::size_t voxel) {
    const float mm = known.triangle[voxel] >= 0 ? known.mm[voxel] : static_cast<float>(band_mm);
    distance_mm.voxels[voxel] = inside[voxel] != 0 ? mm : -mm;
  });
}

}  // namespace

MeshDistance mesh_distance(const TriangleMesh& mesh, const Grid& grid, const MeshDistanceOptions& options,
                           const Progress& progress) {
  require_usable(mesh);
  const double band_mm = checked_band_mm(options.band_mm, grid);
  const MeshTopology topology = topology_of(mesh);
  MeshInside sides = inside_of(mesh, topology, grid, options.sign);
  BandDistances band = scan_band(mesh, topology, grid, band_mm, progress);

  const MeshCells cells(mesh, topology, grid, band_mm);
  CarriedDistances known{std::move(band.mm), std::vector<int>(grid.voxel_count(), -1)};
  bool met = false;
  for (std::size_t voxel = 0; voxel < known.triangle.size(); ++voxel)
    if (band.element[voxel] >= 0) known.triangle[voxel] = cells.triangle_of(band.element[voxel]), met = true;
  const bool full = options.extent == DistanceExtent::full;
  if (full && !met) seed_first_voxel(mesh, grid, known);
  progress.report("far distances", 0);
  // Within the band this finds what rounding may have left out between two cells.
  carry_outwards(mesh, topology, grid, sides.closed ? sides.inside : std::vector<std::uint8_t>(),
                 full ? std::numeric_limits<double>::infinity() : band_mm, known);

  MeshDistance result;
  result.distance_mm = Volume<float>(grid);
  set_signed(known, sides.inside, band_mm, result.distance_mm);
  if (options.keep_closest) keep_closest(mesh, topology, grid, cells, band.element, known, result);
  result.remarks = std::move(sides.remarks);
  return result;
}

Grid distance_grid(const TriangleMesh& mesh, double spacing_mm, double margin_mm) {
  require_usable(mesh);
  if (!(spacing_mm > 0)) throw InputError("distance volume", "its voxels have no size", "give a spacing above 0 mm");
  Eigen::AlignedBox3d box;
  for (const Vector3d& v : mesh.vertices_mm) box.extend(v);
  Grid grid;
  grid.size = ((box.sizes().array() + 2 * margin_mm) / spacing_mm).ceil().cast<int>() + 1;
  grid.index_to_world.linear() *= spacing_mm;
  grid.index_to_world.translation() = box.center() - 0.5 * spacing_mm * (grid.size.array() - 1).matrix().cast<double>();
  return grid;
}

}  // namespace isostack
