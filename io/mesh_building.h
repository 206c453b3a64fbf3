#pragma once

#include <span>
#include <string>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Adds a polygon as a fan of triangles. Throws InputError naming `where` when a corner is not a
/// vertex of the mesh.
void add_polygon(std::span<const long long> corners, TriangleMesh& mesh, const std::string& where);

/// What every mesh reader does at the end: normals become unit vectors, or are dropped when there is not one per
/// vertex. Throws InputError naming `where` when there is no triangle or a coordinate is not a number.
void complete_mesh(TriangleMesh& mesh, const std::string& where);

/// Makes vertices at exactly one place one vertex and drops triangles that collapse. Formats that
/// repeat a vertex for each face or texture would otherwise fall apart at the seams.
void merge_coinciding(TriangleMesh& mesh);

}  // namespace isostack
