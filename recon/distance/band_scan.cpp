#include "recon/distance/band_scan.h"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr int planes_of_slab = 12;

/// The elements that reach each slab, in order.
std::vector<std::vector<int>> elements_of_slabs(const MeshCells& cells, int planes) {
  std::vector<std::vector<int>> elements(static_cast<std::size_t>((planes + planes_of_slab - 1) / planes_of_slab));
  for (int element = 0; element < cells.count(); ++element) {
    const Eigen::Vector2d reach = cells.reach_in_k(element);
    if (!(reach[0] <= planes - 1 && reach[1] >= 0)) continue;
    const int first = static_cast<int>(std::max(0.0, std::floor(reach[0] - 1))) / planes_of_slab;
    const int last = static_cast<int>(std::min(planes - 1.0, std::ceil(reach[1] + 1))) / planes_of_slab;
    for (int slab = first; slab <= last; ++slab) elements[static_cast<std::size_t>(slab)].push_back(element);
  }
  return elements;
}

}  // namespace

BandDistances scan_band(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid, double band_mm,
                        const Progress& progress) {
  const MeshCells cells(mesh, topology, grid, band_mm);
  BandDistances band{std::vector<float>(grid.voxel_count(), std::numeric_limits<float>::infinity()),
                     std::vector<int>(grid.voxel_count(), -1)};
  const auto elements = elements_of_slabs(cells, grid.size.z());
  const Eigen::Vector3d step_mm = grid.index_to_world.linear().col(0);
  progress.report("distances", 0);
  tbb::parallel_for(std::size_t{0}, elements.size(), [&](std::size_t slab) {
    ConvexCell cell;
    const int first_k = static_cast<int>(slab) * planes_of_slab;
    const int last_k = std::min(grid.size.z(), first_k + planes_of_slab) - 1;
    for (const int element : elements[slab]) {
      cells.make(element, cell);
      if (cell.empty()) continue;
      const ElementDistance distance(mesh, topology, cells, element);
      cell.for_each_row(grid.size, first_k, last_k, [&](int j, int k, int first, int last) {
        const Eigen::Vector3d row_mm = grid.index_to_world * Eigen::Vector3d(0, j, k);
        const std::size_t row = grid.offset(0, j, k);
        for (int i = first; i <= last; ++i) {
          const auto mm = static_cast<float>(std::sqrt(distance.squared_mm2(row_mm + i * step_mm)));
          const std::size_t voxel = row + static_cast<std::size_t>(i);
          if (mm < band.mm[voxel] && static_cast<double>(mm) <= band_mm)
            band.mm[voxel] = mm, band.element[voxel] = element;
        }
      });
    }
  });
  return band;
}

double checked_band_mm(double band_mm, const Grid& grid) {
  if (grid.size.minCoeff() < 1 || !(std::abs(grid.index_to_world.linear().determinant()) > 0))
    throw GeometryError("distance volume", "its grid is empty or flat", "give a grid with a size and three axes");
  if (!(band_mm >= 0) || !std::isfinite(band_mm))
    throw InputError("distance volume", "its band is not a length", "give millimetres, or 0 for three voxels");
  return band_mm > 0 ? band_mm : 3 * grid.index_to_world.linear().colwise().norm().maxCoeff();
}

}  // namespace isostack
