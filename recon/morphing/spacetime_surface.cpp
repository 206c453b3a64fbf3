#include "recon/morphing/spacetime_surface.h"

#include <Eigen/Geometry>

#include "recon/surface/extract_surface.h"
#include "recon/surface/stack_caps.h"

namespace isostack {

namespace {

double spacing_mm(const Morph& morph, const std::vector<ContourSlice>& figures) {
  if (morph.report().spacing_mm > 0) return morph.report().spacing_mm;
  Eigen::AlignedBox2d box;
  for (const ContourSlice& figure : figures)
    for (const Contour& contour : figure.contours)
      for (const Eigen::Vector2d& point : contour.points_mm) box.extend(point);
  return box.isEmpty() ? 1 : box.sizes().maxCoeff() / 2;
}

TriangleMesh extracted(const SpacetimeField& spacetime, double resolution_mm, const Progress& progress) {
  const std::vector<Eigen::Hyperplane<double, 3>> ends = {{Eigen::Vector3d::UnitZ(), spacetime.bounds_mm.min()},
                                                          {-Eigen::Vector3d::UnitZ(), spacetime.bounds_mm.max()}};
  ExtractionOptions options{.resolution_mm = resolution_mm, .bounds = spacetime.bounds_mm, .half_spaces = {}};
  // A lid of the extraction would have the width of a cell; going on unchanged for some cells, it is cut exactly.
  options.bounds.min().z() -= 3 * options.resolution_mm;
  options.bounds.max().z() += 3 * options.resolution_mm;
  const ScalarField field = extruded_beyond(spacetime.field, ends);
  return clipped(extract_surface(field, spacetime.seeds_mm, options, progress).mesh, ends);
}

}  // namespace

std::optional<TriangleMesh> spacetime_surface(const Morph& morph, const SlicePose& pose, const Progress& progress) {
  std::optional<TriangleMesh> mesh = morph.spacetime_mesh();
  if (!mesh) {
    const std::optional<SpacetimeField> spacetime = morph.spacetime();
    if (!spacetime) return std::nullopt;
    mesh = extracted(*spacetime, morph.report().resolution_mm, progress);
  }
  mesh->name = "spacetime";
  for (Eigen::Vector3d& vertex : mesh->vertices_mm)
    vertex = pose.slice_to_world(vertex.head<2>()) + vertex.z() * pose.normal();
  for (Eigen::Vector3d& normal : mesh->normals)
    normal = normal.x() * pose.x_axis + normal.y() * pose.y_axis + normal.z() * pose.normal();
  return mesh;
}

ContourStack spacetime_slices(const Morph& morph, const std::vector<ContourSlice>& figures,
                              const std::vector<Eigen::VectorXd>& weights) {
  const KeyPlaces& places = morph.places();
  const bool on_line = places.coordinates.rows() == 1;
  ContourStack stack{.name = "morph", .slices = figures};
  const double unit_mm = spacing_mm(morph, figures);
  double position_mm = on_line ? unit_mm * places.place_at(weights.front())[0] : 0;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (i > 0) {
      const Eigen::VectorXd step = places.place_at(weights[i]) - places.place_at(weights[i - 1]);
      position_mm += unit_mm * (on_line ? step[0] : step.norm());
    }
    SlicePose& pose = stack.slices[i].pose;
    pose.origin_mm += position_mm * pose.normal();
  }
  return stack;
}

}  // namespace isostack
