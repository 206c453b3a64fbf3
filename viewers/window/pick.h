#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "viewers/scene.h"
#include "viewers/view_planes.h"

namespace isostack {

/// What is seen at a pixel lies along this; world mm, direction of unit length, away from the viewer.
struct Ray {
  Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// Where the ray meets the plane within its extent; nothing when it runs along the plane or beside it.
std::optional<Eigen::Vector3d> hit_on_plane(const Ray& ray, const ViewPlane& plane);

/// The part of surfaces that is on the positive side is shown.
using ClipPlane = std::optional<Eigen::Hyperplane<double, 3>>;

/// First point of a visible surface along the ray that is not clipped away.
std::optional<Eigen::Vector3d> hit_on_surfaces(const Ray& ray, const std::vector<SceneSurface>& surfaces,
                                               const ClipPlane& clip);

/// The nearest pixel's value; nothing beside the image.
std::optional<float> grey_at(const Slice& image, const Eigen::Vector2d& point_in_slice_mm);

/// What is known about a point.
struct PointFacts {
  struct Distance {
    std::string name;
    double distance_mm;  ///< to the nearest triangle, unsigned
  };
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();
  std::optional<float> grey;             ///< of the nearest pixel of the plane's image; CT: HU, labels: the label
  std::vector<std::string> inside = {};  ///< organs within whose contours in the plane it lies
  std::vector<Distance> surfaces = {};   ///< visible ones
};

/// `plane`: the one whose image and contours are asked where the point lies in it (within half a millimetre); else, and
/// for nothing, only surfaces are.
PointFacts facts_about(const Eigen::Vector3d& point_mm, const Scene& scene, const ViewPlane* plane);

/// "L 12.3  P -4.0  S 55.1 mm   value 42   in liver   0.12 mm from liver.stl".
std::string to_text(const PointFacts& facts);

}  // namespace isostack
