#include "viewers/scene_points.h"

#include <algorithm>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

void append_checked(const Eigen::Vector3d& point, const std::string& where, std::vector<Eigen::Vector3d>& points) {
  if (!point.allFinite()) throw InputError(where, "a coordinate is not a finite number", "repair it before drawing");
  points.push_back(point);
}

void append_surface(const TriangleMesh& mesh, std::vector<Eigen::Vector3d>& points) {
  const std::string where = mesh.name.empty() ? "surface" : mesh.name;
  const int vertex_count = static_cast<int>(mesh.vertices_mm.size());
  for (const Eigen::Vector3i& triangle : mesh.triangles)
    if (triangle.minCoeff() < 0 || triangle.maxCoeff() >= vertex_count)
      throw InputError(where, "a triangle refers to a vertex that does not exist", "repair the mesh before drawing");
  if (mesh.triangles.empty()) return;
  for (const Eigen::Vector3d& vertex : mesh.vertices_mm) append_checked(vertex, where, points);
}

void append_contours(const ContourStack& organ, std::vector<Eigen::Vector3d>& points) {
  for (const ContourSlice& slice : organ.slices)
    for (const Contour& contour : slice.contours)
      for (const Eigen::Vector2d& point : contour.points_mm)
        append_checked(slice.pose.slice_to_world(point), slice.name.empty() ? "contours" : slice.name, points);
}

}  // namespace

std::array<Eigen::Vector3d, 4> corners_of(const Slice& slice) {
  const double right = static_cast<double>(slice.pixels.cols()) - 0.5;
  const double bottom = static_cast<double>(slice.pixels.rows()) - 0.5;
  return {slice.pose.pixel_to_world({-0.5, -0.5}), slice.pose.pixel_to_world({right, -0.5}),
          slice.pose.pixel_to_world({right, bottom}), slice.pose.pixel_to_world({-0.5, bottom})};
}

std::vector<Eigen::Vector3d> drawn_points(const Scene& scene) {
  std::vector<Eigen::Vector3d> points;
  for (const TriangleMesh& mesh : scene.surfaces) append_surface(mesh, points);
  for (const ContourStack& organ : scene.contours) append_contours(organ, points);
  for (const Slice& slice : scene.slices)
    if (slice.pixels.size() > 0)
      for (const Eigen::Vector3d& corner : corners_of(slice))
        append_checked(corner, slice.name.empty() ? "slice" : slice.name, points);
  if (points.empty())
    throw InputError("scene", "there is nothing to draw", "give it a surface, contours or slices that are not empty");
  return points;
}

}  // namespace isostack
