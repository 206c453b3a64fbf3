#pragma once

#include <filesystem>

#include "io/write_options.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Writes STL (binary), PLY (binary), OBJ, VTP in LPS mm unless the options ask for other axes, or glTF
/// (metres, Y up), by extension.
/// The file appears whole or not at all. Throws InputError naming the file.
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path, const WriteOptions& options = {});

}  // namespace isostack
