#include "io/contours/contours_json.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "io/atomic_file.h"
#include "io/contours/contour_checks.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

using Json = nlohmann::json;
constexpr const char* format_name = "isostack-contours";
constexpr int format_version = 1;

template <int n>
Json to_json(const Eigen::Matrix<double, n, 1>& vector) {
  return std::vector<double>(vector.data(), vector.data() + n);
}

template <class Vector>
Vector vector_from(const Json& json) {
  Vector vector;
  const auto n = static_cast<std::size_t>(vector.size());
  if (!json.is_array() || json.size() != n)
    throw Json::other_error::create(501, fmt::format("an array of {} numbers is expected", n), &json);
  for (std::size_t i = 0; i < n; ++i) {
    const auto number = json[i].get<double>();
    if (std::is_integral_v<typename Vector::Scalar> && std::abs(number) > std::numeric_limits<int>::max())
      throw Json::other_error::create(501, fmt::format("{} is too large a number", number), &json);
    vector[static_cast<int>(i)] = static_cast<typename Vector::Scalar>(number);
  }
  return vector;
}

Json to_json(const ContourSlice& slice) {
  Json contours = Json::array();
  for (const Contour& contour : slice.contours) {
    Json points = Json::array();
    for (const Eigen::Vector2d& point : contour.points_mm) points.push_back(to_json<2>(point));
    contours.push_back({{"points_mm", std::move(points)}});
  }
  return {{"name", slice.name},
          {"pose",
           {{"origin_mm", to_json<3>(slice.pose.origin_mm)},
            {"x_axis", to_json<3>(slice.pose.x_axis)},
            {"y_axis", to_json<3>(slice.pose.y_axis)},
            {"spacing_mm", to_json<2>(slice.pose.spacing_mm)}}},
          {"size_pixels", {slice.size_pixels.x(), slice.size_pixels.y()}},
          {"contours", std::move(contours)}};
}

SlicePose pose_from(const Json& json) {
  SlicePose pose;
  pose.origin_mm = vector_from<Eigen::Vector3d>(json.at("origin_mm"));
  pose.x_axis = vector_from<Eigen::Vector3d>(json.at("x_axis"));
  pose.y_axis = vector_from<Eigen::Vector3d>(json.at("y_axis"));
  pose.spacing_mm = vector_from<Eigen::Vector2d>(json.at("spacing_mm"));
  return pose;
}

ContourSlice slice_from(const Json& json, const std::string& file) {
  ContourSlice slice;
  slice.name = json.at("name").get<std::string>();
  slice.pose = pose_from(json.at("pose"));
  if (json.contains("size_pixels")) slice.size_pixels = vector_from<Eigen::Vector2i>(json["size_pixels"]);
  for (const Json& curve : json.at("contours")) {
    if (!curve.value("closed", true)) throw_open_contour(file, slice.name);
    Contour& contour = slice.contours.emplace_back();
    for (const Json& point : curve.at("points_mm")) contour.points_mm.push_back(vector_from<Eigen::Vector2d>(point));
  }
  complete_slice(slice, file);
  return slice;
}

Color color_from(const Json& json) {
  const auto channels = vector_from<Eigen::Vector3i>(json);
  if (channels.minCoeff() < 0 || channels.maxCoeff() > 255)
    throw Json::other_error::create(501, "a colour has three values from 0 to 255", &json);
  const auto channel = [&](int i) { return static_cast<std::uint8_t>(channels[i]); };
  return {channel(0), channel(1), channel(2)};
}

std::vector<ContourStack> organs_from(const Json& document, const std::string& file) {
  if (document.value("format", "") != format_name || document.value("version", 0.0) != format_version)
    throw InputError(file, fmt::format("it is not \"format\": \"{}\", \"version\": {}", format_name, format_version),
                     "see docs/formats.md for what contours look like");
  std::vector<ContourStack> organs;
  for (const Json& organ : document.at("organs")) {
    ContourStack& stack = organs.emplace_back();
    stack.name = organ.at("name").get<std::string>();
    if (organ.contains("color")) stack.color = color_from(organ["color"]);
    stack.roi_type = organ.value("roi_type", "");
    for (const Json& slice : organ.at("slices")) stack.slices.push_back(slice_from(slice, file));
  }
  return organs;
}

/// What the library says, without its own name and number.
std::string essence_of(const Json::exception& error) {
  const std::string text = error.what();
  const auto end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace

bool is_json_contours(const std::filesystem::path& path) {
  std::ifstream stream(path);
  const Json document = Json::parse(stream, nullptr, false);
  return document.is_object() && document.contains("format") && document["format"] == format_name;
}

ContourFile read_json_contours(const std::filesystem::path& path, const ReadOptions& /*options*/) {
  std::ifstream stream(path);
  try {
    const Json document = Json::parse(stream);
    if (!document.is_object())
      throw InputError(path.string(), "it is not a JSON object", "see docs/formats.md for what contours look like");
    return {.organs = organs_from(document, path.string())};
  } catch (const Json::exception& error) {
    throw InputError(path.string(), "it does not hold contours as expected (" + essence_of(error) + ")",
                     "see docs/formats.md for what contours look like");
  }
}

void write_json_contours(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                         const WriteOptions& /*options*/) {
  Json list = Json::array();
  for (const ContourStack& organ : organs) {
    Json slices = Json::array();
    for (const ContourSlice& slice : organ.slices) slices.push_back(to_json(slice));
    Json& entry = list.emplace_back(Json{{"name", organ.name}, {"slices", std::move(slices)}});
    if (organ.color) entry["color"] = {organ.color->red, organ.color->green, organ.color->blue};
    if (!organ.roi_type.empty()) entry["roi_type"] = organ.roi_type;
  }
  const Json document = {{"format", format_name}, {"version", format_version}, {"organs", std::move(list)}};
  write_whole_file(path, document.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace isostack
