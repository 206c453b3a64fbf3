#include "viewers/camera_presets.h"

#include "recon/geometry/errors.h"

namespace isostack {

const std::vector<std::pair<std::string, Eigen::Vector3d>>& camera_presets() {
  static const std::vector<std::pair<std::string, Eigen::Vector3d>> presets = {
      {"anterior", {0, -1, 0}}, {"posterior", {0, 1, 0}}, {"left", {1, 0, 0}},           {"right", {-1, 0, 0}},
      {"superior", {0, 0, 1}},  {"inferior", {0, 0, -1}}, {"oblique", {0.5, -0.9, 0.35}}};
  return presets;
}

Eigen::Vector3d camera_direction(std::string_view name) {
  std::string names;
  for (const auto& [each, direction] : camera_presets()) {
    if (each == name) return direction;
    names += (names.empty() ? "" : ", ") + each;
  }
  throw InputError("camera", "there is no view \"" + std::string(name) + "\"", "use one of " + names);
}

}  // namespace isostack
