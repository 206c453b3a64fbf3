#include "io/write_mesh.h"

#include "io/formats.h"

namespace isostack {

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path) {
  format_for(path, &Format::write_mesh, "a mesh").write_mesh(mesh, path);
}

}  // namespace isostack
