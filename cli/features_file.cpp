#include "cli/features_file.h"

#include <fmt/format.h>

#include <string>

#include "cli/json_document.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

using Json = nlohmann::json;

/// Where in the file something is, for messages.
struct Place {
  const std::filesystem::path& path;
  std::string name;  ///< "feature 2"
};

constexpr const char* remedy =
    R"(write {"format": "isostack-features", "version": 1, "features": [{"from": {"shape": 0, )"
    R"("vertex": 3}, "to": {"shape": 1, "place_mm": [x, y, z]}}, ...]}; docs/subdivision.md has the rest)";

[[noreturn]] void refuse(const Place& where, const std::string& problem) {
  throw InputError(where.path.string(), where.name.empty() ? problem : where.name + " " + problem, remedy);
}

double number_in(const Json& object, const char* key, const Place& where) {
  const Json value = object.is_object() ? object.value(key, Json()) : Json();
  if (!value.is_number()) refuse(where, fmt::format("has no number \"{}\"", key));
  return value.get<double>();
}

std::size_t whole_in(const Json& object, const char* key, const Place& where) {
  const Json value = object.value(key, Json());
  if (!value.is_number_unsigned()) refuse(where, fmt::format("has no whole number \"{}\" of 0 or more", key));
  return value.get<std::size_t>();
}

Eigen::VectorXd place_in(const Json& object, const char* key, const std::vector<KeyShape>& shapes, const Place& where) {
  const Json value = object.is_object() ? object.value(key, Json()) : Json();
  const bool figures = dimension_of(shapes.front().shape) == 2;
  bool is_place = value.is_array() && (value.size() == 3 || (figures && value.size() == 2));
  for (const Json& number : value) is_place = is_place && number.is_number();
  if (!is_place) refuse(where, fmt::format("has no \"{}\" of three numbers{}", key, figures ? ", or two" : ""));
  Eigen::VectorXd place(static_cast<Eigen::Index>(value.size()));
  for (std::size_t i = 0; i < value.size(); ++i) place[static_cast<Eigen::Index>(i)] = value[i].get<double>();
  return figures && place.size() == 3 ? Eigen::VectorXd(common_pose(shapes).world_to_slice(place.head<3>())) : place;
}

FeaturePoint point_in(const Json& feature, const char* key, const std::vector<KeyShape>& shapes, const Place& where) {
  const Json point = feature.is_object() ? feature.value(key, Json()) : Json();
  if (!point.is_object()) refuse(where, fmt::format("has no \"{}\"", key));
  FeaturePoint result{.shape = whole_in(point, "shape", where), .vertex = {}};
  if (point.contains("vertex"))
    result.vertex = whole_in(point, "vertex", where);
  else
    result.place_mm = place_in(point, "place_mm", shapes, where);
  return result;
}

CorrespondingPoints feature_in(const Json& json, const std::vector<KeyShape>& shapes, const Place& where) {
  CorrespondingPoints feature{.from = point_in(json, "from", shapes, where), .to = point_in(json, "to", shapes, where)};
  for (const Json& place : json.value("by_way_of", Json::array()))
    feature.by_way_of.push_back(
        {.t = number_in(place, "t", where), .place_mm = place_in(place, "place_mm", shapes, where)});
  const Json sharp = json.value("sharp", Json(false));
  if (!sharp.is_boolean()) refuse(where, "has a \"sharp\" that is neither true nor false");
  feature.sharp = sharp.get<bool>();
  return feature;
}

TimeWarp warp_in(const Json& json, const Place& where) {
  bool is_warp = json.is_array() && json.size() == 2 && json[0].is_array() && json[1].is_array() &&
                 json[0].size() == json[1].size();
  for (std::size_t i = 0; is_warp && i < 2; ++i)
    for (const Json& number : json[i]) is_warp = is_warp && number.is_number();
  if (!is_warp) refuse(where, "its \"warp\" is not two lists of numbers of one length");
  TimeWarp warp;
  warp.controls.resize(2, static_cast<Eigen::Index>(json[0].size()));
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t c = 0; c < json[i].size(); ++c)
      warp.controls(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) = json[i][c].get<double>();
  return warp;
}

}  // namespace

FeaturesFile read_features(const std::filesystem::path& path, const std::vector<KeyShape>& shapes) {
  const Json file = read_json_document(path, "isostack-features", remedy);
  FeaturesFile result;
  const Json features = file.value("features", Json::array()), transitions = file.value("transitions", Json::array());
  if (!features.is_array() || !transitions.is_array())
    refuse({path, ""}, "its \"features\" or \"transitions\" are not a list");
  for (const Json& json : features)
    result.features.push_back(feature_in(json, shapes, {path, fmt::format("feature {}", result.features.size() + 1)}));
  for (const Json& json : transitions) {
    const Place where{path, fmt::format("transition {}", result.transitions.size() + 1)};
    result.transitions.push_back(
        {.level = static_cast<int>(number_in(json, "level", where)),
         .at = {.t = number_in(json, "t", where), .place_mm = place_in(json, "place_mm", shapes, where)},
         .to_mm = place_in(json, "to_mm", shapes, where)});
  }
  if (file.contains("warp")) result.warp = warp_in(file["warp"], {path, ""});
  return result;
}

}  // namespace isostack::cli
