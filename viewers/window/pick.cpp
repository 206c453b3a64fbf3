#include "viewers/window/pick.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/metrics/point_triangle.h"

namespace isostack {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Least of value(triangle number) over a mesh's triangles.
template <class Value>
double least_over_triangles(const TriangleMesh& mesh, Value value) {
  const tbb::blocked_range<std::size_t> all(0, mesh.triangles.size(), 4096);
  return tbb::parallel_reduce(
      all, never,
      [&](const tbb::blocked_range<std::size_t>& some, double least) {
        for (std::size_t i = some.begin(); i < some.end(); ++i) least = std::min(least, value(i));
        return least;
      },
      [](double a, double b) { return std::min(a, b); });
}

Triangle corners_of(const TriangleMesh& mesh, std::size_t triangle) {
  const Eigen::Vector3i& corner = mesh.triangles[triangle];
  const auto at = [&](int i) { return mesh.vertices_mm[static_cast<std::size_t>(corner[i])]; };
  return {at(0), at(1), at(2)};
}

/// How far along the ray (either way) it meets the triangle, Möller & Trumbore 1997; `never` when it does not.
double meeting(const Ray& ray, const Triangle& triangle) {
  const Eigen::Vector3d e1 = triangle[1] - triangle[0], e2 = triangle[2] - triangle[0];
  const Eigen::Vector3d p = ray.direction.cross(e2);
  const double determinant = e1.dot(p);
  if (determinant == 0) return never;
  const Eigen::Vector3d s = ray.origin_mm - triangle[0];
  const double u = s.dot(p) / determinant;
  if (u < 0 || u > 1) return never;
  const Eigen::Vector3d q = s.cross(e1);
  const double v = ray.direction.dot(q) / determinant;
  return v < 0 || u + v > 1 ? never : e2.dot(q) / determinant;
}

}  // namespace

std::optional<float> grey_at(const Slice& image, const Eigen::Vector2d& point_in_slice_mm) {
  const Eigen::Vector2d pixel = image.pose.slice_to_pixel(point_in_slice_mm).array().round();
  const bool is_beside = pixel.minCoeff() < 0 || pixel.x() >= static_cast<double>(image.pixels.cols()) ||
                         pixel.y() >= static_cast<double>(image.pixels.rows());
  if (is_beside || !pixel.allFinite()) return std::nullopt;
  return image.pixels(static_cast<Eigen::Index>(pixel.y()), static_cast<Eigen::Index>(pixel.x()));
}

std::optional<Eigen::Vector3d> hit_on_plane(const Ray& ray, const ViewPlane& plane) {
  const double approach = plane.pose.normal().dot(ray.direction);
  if (std::abs(approach) < 1e-6) return std::nullopt;
  const Eigen::Vector3d point = ray.origin_mm - plane.pose.signed_distance_mm(ray.origin_mm) / approach * ray.direction;
  if (!plane.extent_mm.contains(plane.pose.world_to_slice(point))) return std::nullopt;
  return point;
}

std::optional<Eigen::Vector3d> hit_on_surfaces(const Ray& ray, const std::vector<SceneSurface>& surfaces,
                                               const ClipPlane& clip) {
  double nearest = never;
  for (const SceneSurface& surface : surfaces) {
    if (!surface.visible) continue;
    nearest = std::min(nearest, least_over_triangles(surface.mesh, [&](std::size_t i) {
                         const double distance = meeting(ray, corners_of(surface.mesh, i));
                         const bool is_cut_away =
                             clip && clip->signedDistance(ray.origin_mm + distance * ray.direction) < 0;
                         return distance < 0 || is_cut_away ? never : distance;
                       }));
  }
  if (nearest == never) return std::nullopt;
  return ray.origin_mm + nearest * ray.direction;
}

PointFacts facts_about(const Eigen::Vector3d& point_mm, const Scene& scene, const ViewPlane* plane) {
  PointFacts facts{.point_mm = point_mm, .grey = std::nullopt};
  if (plane && std::abs(plane->pose.signed_distance_mm(point_mm)) <= 0.5) {
    if (plane->image) {
      const Slice& image = scene.slices[*plane->image].image;
      facts.grey = grey_at(image, image.pose.world_to_slice(point_mm));
    }
    for (const ViewPlane::Drawn& drawn : plane->contours) {
      const ContourStack& organ = scene.contours[drawn.organ].stack;
      const ContourSlice& slice = organ.slices[drawn.slice];
      if (is_inside(slice.contours, slice.pose.world_to_slice(point_mm))) facts.inside.push_back(organ.name);
    }
  }
  for (const SceneSurface& surface : scene.surfaces) {
    if (!surface.visible || surface.mesh.triangles.empty()) continue;
    const double squared_mm2 = least_over_triangles(surface.mesh, [&](std::size_t i) {
      return (closest_point_on_triangle(corners_of(surface.mesh, i), point_mm) - point_mm).squaredNorm();
    });
    facts.surfaces.push_back({surface.mesh.name.empty() ? "the surface" : surface.mesh.name, std::sqrt(squared_mm2)});
  }
  return facts;
}

std::string to_text(const PointFacts& facts) {
  std::string text =
      fmt::format("L {:.1f}  P {:.1f}  S {:.1f} mm", facts.point_mm.x(), facts.point_mm.y(), facts.point_mm.z());
  if (facts.grey) text += fmt::format("   value {:g}", *facts.grey);
  for (const std::string& organ : facts.inside) text += "   in " + (organ.empty() ? "the contour" : organ);
  for (const PointFacts::Distance& surface : facts.surfaces)
    text += fmt::format("   {:.2f} mm from {}", surface.distance_mm, surface.name);
  return text;
}

}  // namespace isostack
