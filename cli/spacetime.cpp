#include "cli/spacetime.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/stack_caps.h"

namespace isostack::cli {

namespace {

/// A method that knows no distance between key shapes gets that of the variational one, half the figures' size.
double spacing_mm(const std::vector<MorphFrame>& frames, const Morph& morph) {
  if (morph.report().spacing_mm > 0) return morph.report().spacing_mm;
  Eigen::AlignedBox2d box;
  for (const MorphFrame& frame : frames)
    for (const Contour& contour : frame.figure().contours)
      for (const Eigen::Vector2d& point : contour.points_mm) box.extend(point);
  return box.isEmpty() ? 1 : box.sizes().maxCoeff() / 2;
}

}  // namespace

TriangleMesh spacetime_surface(const Morph& morph, const SlicePose& pose, const Progress& progress) {
  if (std::optional<TriangleMesh> mesh = morph.spacetime_mesh()) {
    for (Eigen::Vector3d& vertex : mesh->vertices_mm)
      vertex = pose.slice_to_world(vertex.head<2>()) + vertex.z() * pose.normal();
    return *std::move(mesh);
  }
  const std::optional<SpacetimeField> spacetime = morph.spacetime();
  if (!spacetime)
    throw InputError("-o", "a level-set morph, or shapes that do not lie on a line, have no surface in space-time",
                     "take another method, leave out --path, or write contours (.json, .vtp)");
  const std::vector<Eigen::Hyperplane<double, 3>> ends = {{Eigen::Vector3d::UnitZ(), spacetime->bounds_mm.min()},
                                                          {-Eigen::Vector3d::UnitZ(), spacetime->bounds_mm.max()}};
  ExtractionOptions options{
      .resolution_mm = morph.report().resolution_mm, .bounds = spacetime->bounds_mm, .half_spaces = {}};
  // A lid of the extraction would have the width of a cell; going on unchanged for some cells, it is cut exactly.
  options.bounds.min().z() -= 3 * options.resolution_mm;
  options.bounds.max().z() += 3 * options.resolution_mm;
  const ScalarField field = extruded_beyond(spacetime->field, ends);
  TriangleMesh mesh = clipped(extract_surface(field, spacetime->seeds_mm, options, progress).mesh, ends);
  mesh.name = "spacetime";
  for (Eigen::Vector3d& vertex : mesh.vertices_mm)
    vertex = pose.slice_to_world(vertex.head<2>()) + vertex.z() * pose.normal();
  for (Eigen::Vector3d& normal : mesh.normals)
    normal = normal.x() * pose.x_axis + normal.y() * pose.y_axis + normal.z() * pose.normal();
  return mesh;
}

ContourStack spacetime_slices(const std::vector<MorphFrame>& frames, const Morph& morph) {
  const KeyPlaces& places = morph.places();
  const bool on_line = places.coordinates.rows() == 1;
  ContourStack stack{.name = "morph", .slices = {}};
  const double unit_mm = spacing_mm(frames, morph);
  double position_mm = on_line ? unit_mm * places.place_at(frames.front().weights)[0] : 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i > 0) {
      const Eigen::VectorXd step = places.place_at(frames[i].weights) - places.place_at(frames[i - 1].weights);
      position_mm += unit_mm * (on_line ? step[0] : step.norm());
    }
    ContourSlice slice = frames[i].figure();
    slice.name = frames[i].name;
    slice.pose.origin_mm += position_mm * slice.pose.normal();
    stack.slices.push_back(std::move(slice));
  }
  return stack;
}

}  // namespace isostack::cli
