#include "io/write_mesh.h"

#include "io/formats.h"

namespace isostack {

namespace {

/// LPS and RAS differ by half a turn about the third axis.
TriangleMesh lps_to_ras(TriangleMesh mesh) {
  for (Eigen::Vector3d& vertex : mesh.vertices_mm) vertex.head<2>() *= -1;
  for (Eigen::Vector3d& normal : mesh.normals) normal.head<2>() *= -1;
  return mesh;
}

}  // namespace

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path, const WriteOptions& options) {
  const Format& format = format_for(path, &Format::write_mesh, "a mesh");
  if (options.axes == MeshAxes::ras && !format.prescribes_axes)
    format.write_mesh(lps_to_ras(mesh), path);
  else
    format.write_mesh(mesh, path);
}

}  // namespace isostack
