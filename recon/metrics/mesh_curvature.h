#pragma once

#include <vector>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Mean curvature at every vertex, per mm, positive where the body is convex: 1/r on a sphere of radius r. Of each
/// triangle it is what makes its corners' normals differ as they do, by least squares (Rusinkiewicz 2004); of a vertex
/// the mean over its triangles, weighted by area. Normals are the mesh's, or means over the faces where it has none.
/// Vertices without a triangle of positive area have 0.
std::vector<double> mean_curvatures_per_mm(const TriangleMesh& mesh);

/// The extremes over all vertices, and the 1 % and 99 % quantiles, which a few bad triangles do not move.
struct CurvatureRange {
  double lowest = 0, percentile1 = 0, percentile99 = 0, highest = 0;
};
/// Zero for an empty mesh.
CurvatureRange mean_curvature_range_per_mm(const TriangleMesh& mesh);

}  // namespace isostack
