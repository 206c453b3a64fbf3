#include "viewers/scene_warnings.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "viewers/scene_points.h"

namespace isostack {

namespace {

Eigen::Vector3d half_turned(const Eigen::Vector3d& point) { return {-point.x(), -point.y(), point.z()}; }

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) box.extend(v);
  return box;
}

double longest_side(const Eigen::AlignedBox3d& box) { return box.isEmpty() ? 0 : box.sizes().maxCoeff(); }

/// What surfaces are compared with.
struct Surroundings {
  std::string name;
  Eigen::AlignedBox3d box_mm;
  std::vector<std::vector<Eigen::Vector3d>> organs_mm;  ///< some points of each organ's contours; none of slices
};

std::vector<Eigen::Vector3d> some_of(const std::vector<Eigen::Vector3d>& points) {
  constexpr std::size_t enough = 300;
  const std::size_t step = std::max<std::size_t>(1, points.size() / enough);
  std::vector<Eigen::Vector3d> some;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  return some;
}

std::optional<Surroundings> contours_of(const Scene& scene) {
  Surroundings all{.name = "the contours", .box_mm = {}, .organs_mm = {}};
  for (const SceneContours& item : scene.contours) {
    const std::vector<Eigen::Vector3d> points = visible_points({.contours = {{.stack = item.stack}}});
    if (points.empty()) continue;
    for (const Eigen::Vector3d& point : points) all.box_mm.extend(point);
    all.organs_mm.push_back(some_of(points));
  }
  if (all.organs_mm.empty()) return std::nullopt;
  return all;
}

std::optional<Surroundings> slices_of(const Scene& scene) {
  Surroundings all{.name = "the slices", .box_mm = {}, .organs_mm = {}};
  for (const SceneSlice& item : scene.slices)
    if (item.image.pixels.size() > 0)
      for (const Eigen::Vector3d& corner : corners_of(item.image)) all.box_mm.extend(corner);
  if (all.box_mm.isEmpty()) return std::nullopt;
  return all;
}

/// Every so manieth vertex, as it is or turned half round.
std::vector<Eigen::Vector3d> some_vertices(const TriangleMesh& mesh, bool turned) {
  const std::size_t step = std::max<std::size_t>(1, mesh.vertices_mm.size() / 20'000);
  std::vector<Eigen::Vector3d> some;
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); i += step)
    some.push_back(turned ? half_turned(mesh.vertices_mm[i]) : mesh.vertices_mm[i]);
  return some;
}

/// Mean distance of the points to the nearest vertex.
double mean_distance_mm(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& vertices) {
  double sum = 0;
  for (const Eigen::Vector3d& point : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& vertex : vertices) nearest = std::min(nearest, (vertex - point).squaredNorm());
    sum += std::sqrt(nearest);
  }
  return sum / static_cast<double>(points.size());
}

/// Of the organ that fits best.
double distance_to_contours_mm(const Surroundings& beside, const TriangleMesh& mesh, bool turned) {
  const std::vector<Eigen::Vector3d> vertices = some_vertices(mesh, turned);
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Eigen::Vector3d>& organ : beside.organs_mm)
    least = std::min(least, mean_distance_mm(organ, vertices));
  return least;
}

double share_within(const Eigen::AlignedBox3d& box, const TriangleMesh& mesh, bool turned) {
  const Eigen::Vector3d slack = Eigen::Vector3d::Constant(0.02 * longest_side(box));
  const Eigen::AlignedBox3d wider(box.min() - slack, box.max() + slack);
  const std::vector<Eigen::Vector3d> vertices = some_vertices(mesh, turned);
  const auto inside = std::count_if(vertices.begin(), vertices.end(),
                                    [&](const Eigen::Vector3d& vertex) { return wider.contains(vertex); });
  return static_cast<double>(inside) / static_cast<double>(vertices.size());
}

/// Contours that belong to a surface lie on it; slices are all round it.
bool fits_only_turned(const TriangleMesh& mesh, const Surroundings& beside) {
  if (beside.organs_mm.empty())
    return share_within(beside.box_mm, mesh, false) < 0.5 && share_within(beside.box_mm, mesh, true) > 0.95;
  const double as_is_mm = distance_to_contours_mm(beside, mesh, false);
  return as_is_mm > 0.05 * longest_side(beside.box_mm) && distance_to_contours_mm(beside, mesh, true) < as_is_mm / 3;
}

std::string about_place(const TriangleMesh& mesh, const Surroundings& beside) {
  if (fits_only_turned(mesh, beside))
    return fmt::format(
        "{}: it lies beside {}, but among them when turned from RAS to LPS axes; read it with "
        "--input-axes ras",
        mesh.name, beside.name);
  // Contours may be of another organ than the surface, which is within it or all round it; slices show all of it.
  const bool is_off = beside.organs_mm.empty() ? share_within(beside.box_mm, mesh, false) < 0.5
                                               : !beside.box_mm.intersects(box_of(mesh));
  if (is_off) return fmt::format("{}: it lies outside {}; is it of the same scan?", mesh.name, beside.name);
  return "";
}

/// Of an organ in metres the longest side is 0.002 to 2.
std::string about_size(const TriangleMesh& mesh, double size_mm, const std::optional<Surroundings>& beside) {
  const std::string remedy = "if it is in metres, multiply its coordinates by 1000";
  if (!beside)
    return size_mm < 2 ? fmt::format("{}: it is {:.3g} mm long; {}", mesh.name, size_mm, remedy) : std::string();
  const double beside_mm = longest_side(beside->box_mm);
  if (size_mm < 0.005 * beside_mm)
    return fmt::format("{}: it is {:.3g} mm long and {} {:.3g} mm; {}", mesh.name, size_mm, beside->name, beside_mm,
                       remedy);
  if (size_mm > 200 * beside_mm)
    return fmt::format("{}: it is {:.3g} mm long and {} {:.3g} mm; what is in which unit?", mesh.name, size_mm,
                       beside->name, beside_mm);
  return "";
}

}  // namespace

std::vector<std::string> scene_warnings(const Scene& scene) {
  std::optional<Surroundings> beside = contours_of(scene);
  if (!beside) beside = slices_of(scene);
  std::vector<std::string> warnings;
  for (const SceneSurface& surface : scene.surfaces) {
    if (surface.mesh.vertices_mm.empty()) continue;
    std::string warning = about_size(surface.mesh, longest_side(box_of(surface.mesh)), beside);
    if (warning.empty() && beside) warning = about_place(surface.mesh, *beside);
    if (!warning.empty()) warnings.push_back(warning);
  }
  return warnings;
}

}  // namespace isostack
