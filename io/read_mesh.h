#pragma once

#include <filesystem>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Reads STL, PLY, OBJ or VTP (coinciding STL corners are merged). Coordinates are taken as LPS mm.
/// Throws InputError naming the file.
TriangleMesh read_mesh(const std::filesystem::path& path);

}  // namespace isostack
