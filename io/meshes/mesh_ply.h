#pragma once

#include <filesystem>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Reads text and binary PLY of either byte order; polygons become triangles, properties other than position and
/// normal are skipped. Throws InputError naming the file. (VTK's reader crashes on files that are
/// cut off, and its writer leaves normals out.)
TriangleMesh read_ply(const std::filesystem::path& path);

/// Writes binary PLY, little endian, single precision, with normals if the mesh has them.
void write_ply(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace isostack
