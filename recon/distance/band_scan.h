#pragma once

#include <vector>

#include "recon/distance/mesh_cells.h"
#include "recon/geometry/progress.h"

namespace isostack {

/// Unsigned distances within the band, and what they are to.
struct BandDistances {
  std::vector<float> mm;     ///< as the voxels; infinite beyond the band
  std::vector<int> element;  ///< of MeshCells; -1 beyond the band
};

/// Scan-converts the cells of all elements; of several elements at one voxel the nearest counts, of equally near ones
/// the first. Slabs of planes are worked on in parallel, each by all elements that reach it, in order.
BandDistances scan_band(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid, double band_mm,
                        const Progress& progress);

/// The given width, or three of the grid's longest voxel edges for 0. Throws InputError when it is no length,
/// GeometryError for an empty or flat grid.
double checked_band_mm(double band_mm, const Grid& grid);

}  // namespace isostack
