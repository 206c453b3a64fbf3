#include "recon/surface/retriangulate.h"

#include <Eigen/Geometry>

#include "recon/geometry/stopwatch.h"
#include "recon/metrics/surface_distance.h"
#include "recon/surface/remesh.h"
#include "recon/surface/simplify.h"

namespace isostack {

namespace {

void add_triangle_normals(TriangleMesh& mesh) {
  mesh.normals.assign(mesh.vertices_mm.size(), Eigen::Vector3d::Zero());
  const auto corner = [&](int v) { return mesh.vertices_mm[static_cast<std::size_t>(v)]; };
  for (const Eigen::Vector3i& t : mesh.triangles)
    for (const int v : t)
      mesh.normals[static_cast<std::size_t>(v)] += (corner(t[1]) - corner(t[0])).cross(corner(t[2]) - corner(t[0]));
  for (Eigen::Vector3d& normal : mesh.normals) normal.stableNormalize();
}

void add_gradient_normals(const ScalarField& field, TriangleMesh& mesh) {
  const Eigen::Map<const Eigen::Matrix3Xd> points(mesh.vertices_mm.front().data(), 3,
                                                  static_cast<Eigen::Index>(mesh.vertices_mm.size()));
  const Eigen::Matrix3Xd gradients = field.gradients(points);
  mesh.normals.clear();
  for (Eigen::Index i = 0; i < gradients.cols(); ++i) mesh.normals.push_back(-gradients.col(i).stableNormalized());
}

}  // namespace

TriangleMesh retriangulate(const TriangleMesh& mesh, const RetriangulationOptions& options,
                           RetriangulationReport& report, const ScalarField* field, const Progress& progress) {
  const Stopwatch watch;
  TriangleMesh result = mesh;
  const bool simplifies = options.simplify_tolerance_mm > 0 || options.triangles > 0;
  if (options.edge_length_mm > 0) {
    RemeshedSurface remeshed = remesh(result, {.edge_length_mm = options.edge_length_mm, .field = field}, progress);
    result = std::move(remeshed.mesh);
    report.vertices_off_surface = remeshed.vertices_off_surface;
  }
  if (simplifies)
    result =
        simplify(result, {.tolerance_mm = options.simplify_tolerance_mm, .triangles = options.triangles}, progress);
  if (field != nullptr && !simplifies)
    add_gradient_normals(*field, result);
  else
    add_triangle_normals(result);
  report.triangles_before = mesh.triangles.size();
  report.triangles_after = result.triangles.size();
  report.mean_distance_mm = surface_distance(mesh, result).mean_mm;
  report.largest_distance_mm = largest_distance_mm(mesh, result);
  report.quality = measure_quality(result);
  report.seconds = watch.seconds();
  return result;
}

}  // namespace isostack
