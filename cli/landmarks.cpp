#include "cli/landmarks.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "io/file_listing.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& problem) {
  throw InputError(path.string(), problem,
                   R"(write {"format": "isostack-landmarks", "version": 1, "landmarks": [{"from_mm": [x, y, z], )"
                   R"("to_mm": [x, y, z]}, ...]})");
}

Eigen::Vector3d point_in(const Json& landmark, const char* key, const std::filesystem::path& path, std::size_t number) {
  const Json point = landmark.is_object() ? landmark.value(key, Json()) : Json();
  const bool is_point =
      point.is_array() && point.size() == 3 && point[0].is_number() && point[1].is_number() && point[2].is_number();
  if (!is_point) refuse(path, fmt::format("landmark {} has no {} of three numbers", number, key));
  return {point[0].get<double>(), point[1].get<double>(), point[2].get<double>()};
}

Json parsed(const std::filesystem::path& path) {
  require_exists(path);
  std::ifstream file(path);
  try {
    return Json::parse(file);
  } catch (const Json::exception&) {
    refuse(path, "it is not valid JSON");
  }
}

}  // namespace

std::vector<LandmarkPair> read_landmarks(const std::filesystem::path& path) {
  const Json file = parsed(path);
  if (!file.is_object() || file.value("format", Json()) != "isostack-landmarks" || file.value("version", Json()) != 1)
    refuse(path, "it is not a landmark file of version 1");
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
