#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "viewers/scene.h"

namespace isostack {

/// A plane that can be looked at: its image, or contours, or both.
struct ViewPlane {
  /// Contours of one organ in the plane.
  struct Drawn {
    std::size_t organ, slice;  ///< indices into the scene's contours, and into that stack
  };

  std::string name;
  SlicePose pose;                         ///< of the image, if there is one
  Eigen::AlignedBox2d extent_mm;          ///< slice coordinates: the image's pixels, or what is around the contours
  std::optional<std::size_t> image = {};  ///< index into the scene's slices
  std::vector<Drawn> contours = {};
  std::size_t family = 0;  ///< number of its direction, in the order they first appear
};

/// All planes of a scene: contours drawn on an image lie in that image's plane (within a tenth of a pixel). Parallel
/// planes come together, in order along their normal. Where there is neither image nor contour: axial planes through
/// the surfaces, 1/64 of their height apart.
std::vector<ViewPlane> view_planes(const Scene& scene);

/// Nearest plane through or beside the point, of all families; nothing when there is no plane.
std::optional<std::size_t> plane_nearest_to(const Eigen::Vector3d& point_mm, const std::vector<ViewPlane>& planes);

}  // namespace isostack
