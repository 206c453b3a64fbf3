#pragma once

#include <string>

#include "recon/geometry/contour.h"
#include "recon/geometry/triangle_mesh.h"
#include "viewers/scene.h"

namespace isostack {

/// Distance of each vertex to another surface, mm: positive outside it, negative inside, where the other is closed;
/// else without a sign. `name` of the other goes on the bar. Throws InputError when the other is empty.
VertexValues distance_values(const TriangleMesh& mesh, const TriangleMesh& other, const std::string& name);

/// How well the contours are met: at each vertex the distance, mm, of the contour point nearest to the vertex to the
/// surface. Contours are sampled every `step_mm`. Throws InputError when there is no contour.
VertexValues residual_values(const TriangleMesh& mesh, const ContourStack& contours, double step_mm = 0.5);

/// Mean curvature, per mm, positive where the body is convex: 1/r on a sphere of radius r.
VertexValues curvature_values(const TriangleMesh& mesh);

}  // namespace isostack
