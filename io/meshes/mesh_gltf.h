#pragma once

#include <filesystem>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Writes one self-contained glTF 2.0 file. LPS mm becomes glTF's metres with Y up: the patient
/// stands upright (superior = +Y) and looks along +Z.
/// The mesh's colour becomes that of its material.
void write_gltf(const TriangleMesh& mesh, const std::filesystem::path& path);

/// The same as one binary file.
void write_glb(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace isostack
