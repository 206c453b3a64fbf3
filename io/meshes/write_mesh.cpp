#include "io/meshes/write_mesh.h"

#include "io/formats.h"
#include "io/meshes/mesh_axes.h"

namespace isostack {

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path, const WriteOptions& options) {
  const Format& format = format_for(path, &Format::write_mesh, "a mesh");
  if (options.axes == MeshAxes::ras && !format.prescribes_axes)
    format.write_mesh(lps_to_ras(mesh), path);
  else
    format.write_mesh(mesh, path);
}

}  // namespace isostack
