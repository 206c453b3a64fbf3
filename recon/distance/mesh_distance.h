#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"

namespace isostack {

enum class DistanceExtent {
  band,  ///< voxels farther from the surface than the band hold ±band_mm
  full   ///< and these get the distance to the closest point that fast marching carries to them
};

enum class MeshSign {
  by_crossings,  ///< inside is what rows enter an odd number of times; open meshes by winding
  by_winding     ///< inside is where the winding number of the triangles, turned alike, is beyond 1/2: overlaps unite
};

struct MeshDistanceOptions {
  double band_mm = 0;  ///< distances up to this are exact; 0: three of the grid's longest voxel edges
  DistanceExtent extent = DistanceExtent::full;
  MeshSign sign = MeshSign::by_crossings;
  bool keep_closest = false;  ///< closest point and element of every voxel
};

/// The part of a mesh that is closest to a voxel.
struct MeshElement {
  enum class Kind : std::uint8_t { none, face, edge, vertex };
  Kind kind = Kind::none;
  int index = -1;  ///< triangle · 3 × triangle + side, from its corner `side` to the next · vertex
};

struct MeshDistance {
  Volume<float> distance_mm;                       ///< positive inside
  std::vector<Eigen::Vector3d> closest_points_mm;  ///< as the voxels, world; empty unless kept
  std::vector<MeshElement> closest_elements;       ///< as the voxels; empty unless kept. Beyond the band: faces
  std::vector<std::string> remarks;                ///< one sentence each: the mesh is not closed and so on
};

/// The signed distance to a closed mesh in mm, positive inside, at the voxels of a grid in any position, by the method
/// of characteristics (Breen et al. 2001, §4.1; Mauch): prisms over faces, wedges over edges, cones over vertices
/// hold the points nearest to these, and are scan-converted plane by plane, row by row. Time is linear in faces and
/// voxels within the band. Within the band a distance is exact up to rounding to float; beyond it the closest triangle
/// of the neighbours, or one beside it, is taken for the closest (§4.2).
///
/// Inside is what rows enter an odd number of times: right for every mesh whose edges all have two (an even number
/// of) triangles, whatever their orientation; overlapping parts of one mesh cancel. An open mesh gets a remark, and
/// inside is then where the generalised winding number (Jacobson et al. 2013), its triangles first turned alike, is
/// beyond 1/2: a hole is closed by some smooth patch. Voxels without a closest element (band only) have kind none and
/// a NaN point.
///
/// The result does not depend on the number of threads. Throws InputError, naming the mesh, when it has no triangles,
/// names a vertex that does not exist or has coordinates that are not finite; GeometryError for an empty or flat grid.
MeshDistance mesh_distance(const TriangleMesh& mesh, const Grid& grid, const MeshDistanceOptions& options = {},
                           const Progress& progress = {});

/// A grid along the world's axes with cubic voxels round a mesh and `margin_mm` more on every side.
Grid distance_grid(const TriangleMesh& mesh, double spacing_mm, double margin_mm);

}  // namespace isostack
