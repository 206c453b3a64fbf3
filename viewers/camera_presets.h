#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isostack {

/// Names and directions from the scene's centre to the camera, LPS: anterior, posterior, left, right, superior,
/// inferior and oblique, the default.
const std::vector<std::pair<std::string, Eigen::Vector3d>>& camera_presets();

/// Throws InputError listing the names when there is none like it.
Eigen::Vector3d camera_direction(std::string_view name);

}  // namespace isostack
