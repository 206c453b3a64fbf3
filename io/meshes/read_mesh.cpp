#include "io/meshes/read_mesh.h"

#include "io/file_listing.h"
#include "io/formats.h"
#include "io/meshes/mesh_axes.h"

namespace isostack {

TriangleMesh read_mesh(const std::filesystem::path& path, MeshAxes axes) {
  require_exists(path);
  TriangleMesh mesh = format_for(path, &Format::read_mesh, "a mesh").read_mesh(path);
  if (mesh.name.empty()) mesh.name = path.stem().string();
  return axes == MeshAxes::ras ? lps_to_ras(std::move(mesh)) : mesh;  // the turn is its own inverse
}

}  // namespace isostack
