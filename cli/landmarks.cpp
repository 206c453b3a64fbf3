#include "cli/landmarks.h"

#include <fmt/format.h>

#include <string>

#include "cli/json_document.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

using Json = nlohmann::json;

constexpr const char* remedy =
    R"(write {"format": "isostack-landmarks", "version": 1, "landmarks": [{"from_mm": [x, y, z], )"
    R"("to_mm": [x, y, z]}, ...]})";

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& problem) {
  throw InputError(path.string(), problem, remedy);
}

Eigen::Vector3d point_in(const Json& landmark, const char* key, const std::filesystem::path& path, std::size_t number) {
  const Json point = landmark.is_object() ? landmark.value(key, Json()) : Json();
  const bool is_point =
      point.is_array() && point.size() == 3 && point[0].is_number() && point[1].is_number() && point[2].is_number();
  if (!is_point) refuse(path, fmt::format("landmark {} has no {} of three numbers", number, key));
  return {point[0].get<double>(), point[1].get<double>(), point[2].get<double>()};
}

}  // namespace

std::vector<LandmarkPair> read_landmarks(const std::filesystem::path& path) {
  const Json file = read_json_document(path, "isostack-landmarks", remedy);
  const Json list = file.value("landmarks", Json());
  if (!list.is_array() || list.empty()) refuse(path, "it holds no landmarks");
  std::vector<LandmarkPair> landmarks;
  for (const Json& landmark : list) {
    const std::size_t number = landmarks.size() + 1;
    landmarks.push_back(
        {.from_mm = point_in(landmark, "from_mm", path, number), .to_mm = point_in(landmark, "to_mm", path, number)});
  }
  return landmarks;
}

}  // namespace isostack::cli
