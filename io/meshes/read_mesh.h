#pragma once

#include <filesystem>

#include "io/write_options.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Reads STL, PLY, OBJ or VTP (coinciding STL corners are merged). Coordinates are mm in the given axes; the mesh is
/// in LPS. Its name is the file's unless the file holds one. Throws InputError naming the file.
TriangleMesh read_mesh(const std::filesystem::path& path, MeshAxes axes = MeshAxes::lps);

}  // namespace isostack
