#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/color.h"

namespace isostack {

/// Indexed triangles in world LPS mm; corners run counter-clockwise seen from outside, so that
/// face normals point outwards. Normals are empty or one unit vector per vertex, outwards.
struct TriangleMesh {
  std::string name;
  std::vector<Eigen::Vector3d> vertices_mm;
  std::vector<Eigen::Vector3i> triangles;
  std::vector<Eigen::Vector3d> normals;
  std::optional<Color> color = std::nullopt;
};

}  // namespace isostack
