#include "io/read_mesh.h"

#include "io/file_listing.h"
#include "io/formats.h"

namespace isostack {

TriangleMesh read_mesh(const std::filesystem::path& path) {
  require_exists(path);
  TriangleMesh mesh = format_for(path, &Format::read_mesh, "a mesh").read_mesh(path);
  mesh.name = path.stem().string();
  return mesh;
}

}  // namespace isostack
