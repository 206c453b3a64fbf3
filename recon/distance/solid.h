#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/distance/mesh_distance.h"
#include "recon/geometry/csg_solid.h"
#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// A function that is positive inside the solid, 0 on its surface and negative outside, without a unit: 1 − ρ for a
/// superellipsoid, where ρ is how far from its centre the point is, 1 on the surface; the largest of a union, the
/// smallest of an intersection, min(a, −b) for a \ b.
double implicit_value(const CsgSolid& solid, const Eigen::Vector3d& point_mm);

/// Round the solid (parts that are taken away do not count).
Eigen::AlignedBox3d box_of(const CsgSolid& solid);

struct SolidDistanceOptions {
  double tolerance_mm = 0;  ///< how far distances may be off; 0: 2.5e-4 of the diagonal of the solid's box
  double band_mm = 0;       ///< as MeshDistanceOptions have it
  DistanceExtent extent = DistanceExtent::full;
  bool keep_closest = false;
};

struct SolidDistance {
  Volume<float> distance_mm;                       ///< positive inside
  std::vector<Eigen::Vector3d> closest_points_mm;  ///< as the voxels, NaN where none was looked for; empty unless kept
  double error_mm = 0;                             ///< the tolerance that was used, whatever the voxels' size
};

/// The signed distance to a constructive solid in mm (Breen et al. 2001, §4.2). The zero set: the surface of every
/// superellipsoid is sampled by triangles, halved until they are within the tolerance of it, and the rules of Tables
/// 1–3 say which of them are on the solid's surface (the tables have negative inside; here a union is where the largest
/// value is 0, an intersection where the smallest is, and a \ b is a ∩ ¬b); triangles that are partly on it are halved
/// down to the tolerance. Within the band their cells are scan-converted (mesh_distance); beyond it, when the extent is
/// full, a tree of boxes finds the point of the zero set closest to each voxel. Signs are those of implicit_value.
///
/// The paper applies the rules to the closest points of every voxel, discards those that are not on the solid, and
/// marches from the others; applied to the surface itself they leave none to discard. Marching is several times
/// faster than the tree, but may miss the closest point by a share of a voxel: then the error would grow with the
/// voxels (docs/distance.md has figures). Parts smaller than 1/64 of a superellipsoid may be missed; faces that two
/// parts have exactly in common count as surface, also where they are inside a union.
/// Throws InputError, naming the solid, when it is empty or one of its numbers is out of range.
SolidDistance solid_distance(const CsgSolid& solid, const Grid& grid, const SolidDistanceOptions& options = {},
                             const Progress& progress = {});

/// The zero set by itself: triangles, turned outwards or inwards, with gaps of at most the tolerance. Neighbours on one
/// superellipsoid share vertices.
TriangleMesh solid_samples(const CsgSolid& solid, double tolerance_mm);

/// A grid along the world's axes with cubic voxels round a solid and `margin_mm` more on every side.
Grid distance_grid(const CsgSolid& solid, double spacing_mm, double margin_mm);

}  // namespace isostack
