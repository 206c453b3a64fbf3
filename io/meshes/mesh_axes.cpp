#include "io/meshes/mesh_axes.h"

namespace isostack {

TriangleMesh lps_to_ras(TriangleMesh mesh) {
  for (Eigen::Vector3d& vertex : mesh.vertices_mm) vertex.head<2>() *= -1;
  for (Eigen::Vector3d& normal : mesh.normals) normal.head<2>() *= -1;
  return mesh;
}

}  // namespace isostack
