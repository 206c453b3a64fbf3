#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "viewers/palette.h"
#include "viewers/scene.h"

namespace isostack {

// Colours of what only windows draw, seen on grey images and on white alike.
inline const Eigen::Vector3d pick_colour = {0.90, 0.10, 0.60};
inline const Eigen::Vector3d seed_colour = {0.10, 0.65, 0.20};
inline const Eigen::Vector3d unwanted_colour = {0.85, 0.15, 0.10};
inline const Eigen::Vector3d replay_colour = {1.00, 0.85, 0.10};
inline const Eigen::Vector3d dropped_colour = {0.55, 0.55, 0.55};
inline const Eigen::Vector3d side_letter_colour = {0.95, 0.60, 0.10};

inline Eigen::Vector3d rgb_of(const Color& color) { return Eigen::Vector3d(color.red, color.green, color.blue) / 255; }

/// As the scene draws them.
inline Eigen::Vector3d surface_colour(const Scene& scene, std::size_t index) {
  const auto& own = scene.surfaces[index].mesh.color;
  return own ? rgb_of(*own) : organ_colours(index).surface;
}
inline Eigen::Vector3d contour_colour(const Scene& scene, std::size_t index) {
  const auto& own = scene.contours[index].stack.color;
  return own ? rgb_of(*own) : organ_colours(index).contour;
}

}  // namespace isostack
