#include "viewers/view_planes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace isostack {

namespace {

Eigen::AlignedBox2d extent_of(const SlicePose& pose, Eigen::Index columns, Eigen::Index rows) {
  const Eigen::Vector2d last(static_cast<double>(columns) - 0.5, static_cast<double>(rows) - 0.5);
  return {pose.pixel_to_slice({-0.5, -0.5}), pose.pixel_to_slice(last)};
}

/// A tenth more on every side, and a millimetre so that a point has an extent.
Eigen::AlignedBox2d widened(Eigen::AlignedBox2d box) {
  const Eigen::Vector2d margin = 0.1 * box.sizes() + Eigen::Vector2d::Ones();
  return {box.min() - margin, box.max() + margin};
}

class PlaneList {
 public:
  std::vector<ViewPlane> planes;

  void add_image(const Slice& slice, std::size_t index) {
    ViewPlane& plane = planes.emplace_back();
    plane.name = slice.name;
    plane.pose = slice.pose;
    plane.extent_mm = extent_of(slice.pose, slice.pixels.cols(), slice.pixels.rows());
    plane.image = index;
    plane.family = family_of(slice.pose);
  }

  void add_contours(const ContourSlice& slice, ViewPlane::Drawn place) {
    ViewPlane* plane = plane_of(slice.pose);
    if (!plane) {
      plane = &planes.emplace_back();
      plane->name = slice.name;
      plane->pose = slice.pose;
      plane->family = family_of(slice.pose);
      if (slice.size_pixels.minCoeff() > 0)
        plane->extent_mm = extent_of(slice.pose, slice.size_pixels.x(), slice.size_pixels.y());
    }
    plane->contours.push_back(place);
    if (plane->image || slice.size_pixels.minCoeff() > 0) return;
    for (const Contour& contour : slice.contours)
      for (const Eigen::Vector2d& point : contour.points_mm)
        plane->extent_mm.extend(plane->pose.world_to_slice(slice.pose.slice_to_world(point)));
  }

  std::size_t family_of(const SlicePose& pose) {
    const auto same =
        std::find_if(families_.begin(), families_.end(), [&](const SlicePose& one) { return are_parallel(one, pose); });
    if (same == families_.end()) return families_.push_back(pose), families_.size() - 1;
    return static_cast<std::size_t>(same - families_.begin());
  }

  double along_normal_mm(const ViewPlane& plane) const {
    return families_[plane.family].signed_distance_mm(plane.pose.origin_mm);
  }

 private:
  std::vector<SlicePose> families_;

  ViewPlane* plane_of(const SlicePose& pose) {
    const double tolerance_mm = 0.1 * pose.spacing_mm.minCoeff();
    const auto same = std::find_if(planes.begin(), planes.end(), [&](const ViewPlane& plane) {
      return in_one_plane(plane.pose, pose, tolerance_mm);
    });
    return same == planes.end() ? nullptr : &*same;
  }
};

std::vector<ViewPlane> axial_planes(const std::vector<SceneSurface>& surfaces) {
  Eigen::AlignedBox3d box;
  for (const SceneSurface& surface : surfaces)
    for (const Eigen::Vector3d& vertex : surface.mesh.vertices_mm) box.extend(vertex);
  std::vector<ViewPlane> planes;
  if (box.isEmpty()) return planes;
  constexpr int steps = 64;
  for (int k = 0; k <= steps; ++k) {
    ViewPlane& plane = planes.emplace_back();
    plane.pose.origin_mm = box.min() + Eigen::Vector3d(0, 0, box.sizes().z() * k / steps);
    plane.name = fmt::format("axial {:.1f} mm", plane.pose.origin_mm.z());
    plane.extent_mm = widened({Eigen::Vector2d::Zero(), box.sizes().head<2>()});
  }
  return planes;
}

}  // namespace

std::vector<ViewPlane> view_planes(const Scene& scene) {
  PlaneList list;
  for (std::size_t i = 0; i < scene.slices.size(); ++i)
    if (scene.slices[i].image.pixels.size() > 0) list.add_image(scene.slices[i].image, i);
  for (std::size_t organ = 0; organ < scene.contours.size(); ++organ) {
    const std::vector<ContourSlice>& slices = scene.contours[organ].stack.slices;
    for (std::size_t slice = 0; slice < slices.size(); ++slice) list.add_contours(slices[slice], {organ, slice});
  }
  if (list.planes.empty()) return axial_planes(scene.surfaces);
  for (ViewPlane& plane : list.planes) {
    if (plane.extent_mm.isEmpty()) plane.extent_mm.extend(Eigen::Vector2d::Zero().eval());
    const bool is_of_image =
        plane.image || std::any_of(plane.contours.begin(), plane.contours.end(), [&](const auto& d) {
          return scene.contours[d.organ].stack.slices[d.slice].size_pixels.minCoeff() > 0;
        });
    if (!is_of_image) plane.extent_mm = widened(plane.extent_mm);
  }
  std::stable_sort(list.planes.begin(), list.planes.end(), [&](const ViewPlane& a, const ViewPlane& b) {
    return std::make_tuple(a.family, list.along_normal_mm(a)) < std::make_tuple(b.family, list.along_normal_mm(b));
  });
  return list.planes;
}

std::optional<std::size_t> plane_nearest_to(const Eigen::Vector3d& point_mm, const std::vector<ViewPlane>& planes) {
  std::optional<std::size_t> nearest;
  double least_mm = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const double distance_mm = std::abs(planes[i].pose.signed_distance_mm(point_mm));
    if (distance_mm < least_mm && planes[i].extent_mm.contains(planes[i].pose.world_to_slice(point_mm)))
      nearest = i, least_mm = distance_mm;
  }
  return nearest;
}

}  // namespace isostack
