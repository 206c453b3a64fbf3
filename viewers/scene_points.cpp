#include "viewers/scene_points.h"

#include <algorithm>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

void append(const TriangleMesh& mesh, std::vector<Eigen::Vector3d>& points) {
  if (mesh.triangles.empty()) return;
  points.insert(points.end(), mesh.vertices_mm.begin(), mesh.vertices_mm.end());
}

void append(const ContourStack& organ, std::vector<Eigen::Vector3d>& points) {
  for (const ContourSlice& slice : organ.slices)
    for (const Contour& contour : slice.contours)
      for (const Eigen::Vector2d& point : contour.points_mm) points.push_back(slice.pose.slice_to_world(point));
}

void append(const Slice& slice, std::vector<Eigen::Vector3d>& points) {
  if (slice.pixels.size() == 0) return;
  const auto corners = corners_of(slice);
  points.insert(points.end(), corners.begin(), corners.end());
}

/// Appends the points of one item, if they are numbers. Returns whether there are any.
template <class Item>
bool has_points(const Item& item, const std::string& where) {
  std::vector<Eigen::Vector3d> points;
  append(item, points);
  if (!std::all_of(points.begin(), points.end(), [](const Eigen::Vector3d& point) { return point.allFinite(); }))
    throw InputError(where, "a coordinate is not a finite number", "repair it before drawing");
  return !points.empty();
}

void require_sound(const SceneSurface& surface, const std::string& where) {
  const int vertex_count = static_cast<int>(surface.mesh.vertices_mm.size());
  for (const Eigen::Vector3i& triangle : surface.mesh.triangles)
    if (triangle.minCoeff() < 0 || triangle.maxCoeff() >= vertex_count)
      throw InputError(where, "a triangle refers to a vertex that does not exist", "repair the mesh before drawing");
  if (surface.values && surface.values->values.size() != surface.mesh.vertices_mm.size())
    throw InputError(where, "it has not one value for each vertex", "compute the values on this mesh");
}

std::string name_or(const std::string& name, const char* otherwise) { return name.empty() ? otherwise : name; }

}  // namespace

std::array<Eigen::Vector3d, 4> corners_of(const Slice& slice) {
  const double right = static_cast<double>(slice.pixels.cols()) - 0.5;
  const double bottom = static_cast<double>(slice.pixels.rows()) - 0.5;
  return {slice.pose.pixel_to_world({-0.5, -0.5}), slice.pose.pixel_to_world({right, -0.5}),
          slice.pose.pixel_to_world({right, bottom}), slice.pose.pixel_to_world({-0.5, bottom})};
}

std::vector<Eigen::Vector3d> visible_points(const Scene& scene) {
  std::vector<Eigen::Vector3d> points;
  for (const SceneSurface& item : scene.surfaces)
    if (item.visible) append(item.mesh, points);
  for (const SceneContours& item : scene.contours)
    if (item.visible) append(item.stack, points);
  for (const SceneSlice& item : scene.slices)
    if (item.visible) append(item.image, points);
  for (const SceneMark& item : scene.marks)
    if (item.visible) points.insert(points.end(), {item.from_mm, item.to_mm});
  return points;
}

GreyWindow automatic_grey_window(const Scene& scene) {
  std::vector<const Image<float>*> images;
  for (const SceneSlice& slice : scene.slices) images.push_back(&slice.image.pixels);
  return automatic_grey_window(images);
}

void require_drawable(const Scene& scene) {
  bool has_any = false;
  for (const SceneSurface& item : scene.surfaces) {
    const std::string where = name_or(item.mesh.name, "surface");
    require_sound(item, where);
    has_any |= has_points(item.mesh, where);
  }
  for (const SceneContours& item : scene.contours)
    has_any |= has_points(item.stack, name_or(item.stack.name, "contours"));
  for (const SceneSlice& item : scene.slices) has_any |= has_points(item.image, name_or(item.image.name, "slice"));
  for (const SceneMark& mark : scene.marks)
    if (!mark.from_mm.allFinite() || !mark.to_mm.allFinite())
      throw InputError("mark", "a coordinate is not a finite number", "leave it out");
  if (!has_any)
    throw InputError("scene", "there is nothing to draw", "give it a surface, contours or slices that are not empty");
}

}  // namespace isostack
