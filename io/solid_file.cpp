#include "io/solid_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string_view>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

using Json = nlohmann::json;
constexpr int deepest = 64;

/// A value and where it stands, as "file, /solid/union/0".
struct Place {
  const Json& json;
  std::string where;

  Place at(const char* key) const { return {json.at(key), where + "/" + key}; }
  Place at(std::size_t index) const { return {json.at(index), fmt::format("{}/{}", where, index)}; }
  bool has(const char* key) const { return json.contains(key); }
};

[[noreturn]] void refuse(const Place& place, const std::string& problem, const std::string& remedy) {
  throw InputError(place.where, problem, remedy);
}

void require_object(const Place& place, std::initializer_list<std::string_view> keys) {
  if (!place.json.is_object()) refuse(place, "an object is expected here", "see docs/distance.md for the format");
  for (const auto& [key, value] : place.json.items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      refuse(place, fmt::format("the key '{}' is unknown", key.substr(0, 40)),
             fmt::format("only {} may stand here", fmt::join(keys, ", ")));
}

void require(const Place& place, const char* key) {
  if (!place.has(key))
    refuse(place, fmt::format("the key '{}' is missing", key), "see docs/distance.md for the format");
}

std::vector<double> numbers_in(const Place& place, std::size_t count) {
  if (!place.json.is_array() || place.json.size() != count)
    refuse(place, fmt::format("{} numbers in brackets are expected", count), "see docs/distance.md for the format");
  std::vector<double> numbers;
  for (const Json& number : place.json) {
    if (!number.is_number() || !std::isfinite(number.get<double>()))
      refuse(place, "something is not a number", fmt::format("give {} numbers", count));
    numbers.push_back(number.get<double>());
  }
  return numbers;
}

Eigen::Affine3d affine_in(const Place& place) {
  if (!place.json.is_array() || place.json.size() != 3)
    refuse(place, "three rows of four numbers are expected", "see docs/distance.md for the format");
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  for (std::size_t row = 0; row < 3; ++row) {
    const std::vector<double> numbers = numbers_in(place.at(row), 4);
    map.matrix().row(static_cast<Eigen::Index>(row)) = Eigen::RowVector4d::Map(numbers.data());
  }
  if (!(std::abs(map.linear().determinant()) > 0))
    refuse(place, "the map flattens the solid", "give one that can be undone");
  return map;
}

void read_superellipsoid(const Place& place, CsgSolid& solid) {
  require_object(place, {"radii_mm", "exponents"});
  require(place, "radii_mm");
  solid.radii_mm = Eigen::Vector3d::Map(numbers_in(place.at("radii_mm"), 3).data());
  if (solid.radii_mm.minCoeff() <= 0)
    refuse(place.at("radii_mm"), "a radius is not above 0", "give three lengths in mm");
  if (!place.has("exponents")) return;
  solid.exponents = Eigen::Vector2d::Map(numbers_in(place.at("exponents"), 2).data());
  if (solid.exponents.minCoeff() < 0.1 || solid.exponents.maxCoeff() > 2)
    refuse(place.at("exponents"), "an exponent is not from 0.1 to 2", "give 1 for round, 0.1 for nearly square");
}

CsgSolid node_in(const Place& place, const Eigen::Affine3d& outer, int depth) {
  if (depth > deepest) refuse(place, "solids are nested too deeply", fmt::format("use at most {} levels", deepest));
  require_object(place, {"name", "affine", "superellipsoid", "union", "intersection", "difference"});
  const Eigen::Affine3d to_world = place.has("affine") ? outer * affine_in(place.at("affine")) : outer;
  CsgSolid solid;
  if (place.has("name")) {
    if (!place.json["name"].is_string()) refuse(place.at("name"), "a name is a text", "put it in quotes");
    solid.name = place.json["name"].get<std::string>();
  }
  int found = 0;
  const auto is_a = [&](const char* key) { return place.has(key) && ++found == 1; };
  if (is_a("superellipsoid")) {
    read_superellipsoid(place.at("superellipsoid"), solid);
    solid.to_world = to_world;
  }
  using Kind = CsgSolid::Kind;
  for (const auto& [key, kind] :
       {std::pair{"union", Kind::set_union}, {"intersection", Kind::intersection}, {"difference", Kind::difference}}) {
    if (!is_a(key)) continue;
    const Place parts = place.at(key);
    if (!parts.json.is_array() || parts.json.empty())
      refuse(parts, "the set operation is empty", "list its solids in brackets");
    solid.kind = kind;
    for (std::size_t i = 0; i < parts.json.size(); ++i)
      solid.parts.push_back(node_in(parts.at(i), to_world, depth + 1));
  }
  if (found != 1)
    refuse(place, found == 0 ? "it says nothing of a shape" : "it has several shapes",
           "give one of superellipsoid, union, intersection, difference");
  return solid;
}

}  // namespace

CsgSolid read_solid(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string(), "it cannot be read", "check the name and the permissions");
  const Json json = Json::parse(stream, nullptr, false);
  const Place file{json, path.string() + ", "};
  if (json.is_discarded() || !json.is_object() || json.value("format", Json()) != "isostack-solid")
    throw InputError(path.string(), "it is not a solid", "it must be JSON with \"format\": \"isostack-solid\"");
  require_object(file, {"format", "version", "solid"});
  require(file, "solid");
  if (json.value("version", Json()) != 1)
    throw InputError(path.string(), "its version is not 1", "write it as version 1");
  CsgSolid solid = node_in(file.at("solid"), Eigen::Affine3d::Identity(), 0);
  if (solid.name.empty()) solid.name = path.string();
  return solid;
}

bool holds_solid(const std::filesystem::path& path) {
  if (path.extension() != ".json") return false;
  std::string start(1000, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start.find("\"isostack-solid\"") != std::string::npos;
}

}  // namespace isostack
