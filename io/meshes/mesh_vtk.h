#pragma once

#include <filesystem>

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// Readers. Polygons are split into triangles; corners of STL and OBJ at one place become one
/// vertex. Each throws InputError naming the file when it is damaged or holds no triangle.
TriangleMesh read_stl(const std::filesystem::path& path);
TriangleMesh read_obj(const std::filesystem::path& path);
TriangleMesh read_vtp_mesh(const std::filesystem::path& path);

/// Writers, LPS mm, with the mesh's normals except for STL, which has none per vertex. STL is
/// binary with single precision, VTP binary with double precision, OBJ has 9 digits.
void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path);
void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path);
void write_vtp_mesh(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace isostack
