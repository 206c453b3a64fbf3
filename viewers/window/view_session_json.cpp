#include "viewers/window/view_session_json.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace isostack {

namespace {

using Json = nlohmann::json;

template <class Value, std::size_t n>
using Names = std::array<std::pair<Value, std::string_view>, n>;

constexpr Names<WindowLayout, 3> layout_names = {
    {{WindowLayout::both, "both"}, {WindowLayout::scene, "scene"}, {WindowLayout::slice, "slice"}}};
constexpr Names<PointerMode, 4> pointer_names = {{{PointerMode::pick, "pick"},
                                                  {PointerMode::measure, "measure"},
                                                  {PointerMode::edit, "edit"},
                                                  {PointerMode::seed, "seed"}}};
constexpr Names<ClipSide, 3> clip_names = {
    {{ClipSide::none, "none"}, {ClipSide::front, "front"}, {ClipSide::back, "back"}}};
constexpr Names<ImagesShown, 3> image_names = {
    {{ImagesShown::shown_plane, "shown_plane"}, {ImagesShown::all, "all"}, {ImagesShown::none, "none"}}};
constexpr Names<EditKind, 4> edit_names = {{{EditKind::move_point, "move_point"},
                                            {EditKind::add_point, "add_point"},
                                            {EditKind::delete_point, "delete_point"},
                                            {EditKind::drop_slice, "drop_slice"}}};

[[noreturn]] void refuse(const std::string& problem, const Json& json) {
  throw Json::other_error::create(501, problem, &json);
}

template <class Value, std::size_t n>
std::string name_of(Value value, const Names<Value, n>& names) {
  for (const auto& [known, name] : names)
    if (known == value) return std::string(name);
  return {};
}

template <class Value, std::size_t n>
void read_name(const Json& json, const char* key, const Names<Value, n>& names, Value& value) {
  if (!json.contains(key)) return;
  const std::string wanted = json[key].get<std::string>();
  for (const auto& [known, name] : names)
    if (name == wanted) {
      value = known;
      return;
    }
  refuse(fmt::format("\"{}\" cannot be \"{}\"", key, wanted), json);
}

template <int n>
Json numbers(const Eigen::Matrix<double, n, 1>& vector) {
  return std::vector<double>(vector.data(), vector.data() + n);
}

template <int n>
Eigen::Matrix<double, n, 1> vector_from(const Json& json) {
  if (!json.is_array() || json.size() != n) refuse(fmt::format("an array of {} numbers is expected", n), json);
  Eigen::Matrix<double, n, 1> vector;
  for (int i = 0; i < n; ++i) vector[i] = json[static_cast<std::size_t>(i)].get<double>();
  return vector;
}

std::size_t index_from(const Json& json, const char* key) {
  const double number = json.value(key, 0.0);
  if (!(number >= 0 && number < 1e9) || std::floor(number) != number)
    refuse(fmt::format("\"{}\" is not a number from 0", key), json);
  return static_cast<std::size_t>(number);
}

double positive_from(const Json& json, const char* key, double fallback, double most) {
  const double number = json.value(key, fallback);
  if (!(number > 0 && number <= most)) refuse(fmt::format("\"{}\" is not in (0, {:g}]", key, most), json);
  return number;
}

Json to_json(const ContourEdit& edit) {
  Json json = {{"kind", name_of(edit.kind, edit_names)}, {"organ", edit.organ}, {"slice", edit.slice}};
  if (edit.kind == EditKind::drop_slice) return json;
  json["contour"] = edit.contour;
  json["point"] = edit.point;
  if (edit.kind != EditKind::delete_point) json["to_mm"] = numbers<2>(edit.to_mm);
  if (edit.kind == EditKind::move_point) json["reach_mm"] = edit.reach_mm;
  return json;
}

ContourEdit edit_from(const Json& json) {
  if (!json.contains("kind")) refuse("an edit has no \"kind\"", json);
  ContourEdit edit;
  read_name(json, "kind", edit_names, edit.kind);
  edit.organ = index_from(json, "organ");
  edit.slice = index_from(json, "slice");
  edit.contour = index_from(json, "contour");
  edit.point = index_from(json, "point");
  if (edit.kind == EditKind::move_point || edit.kind == EditKind::add_point)
    edit.to_mm = vector_from<2>(json.at("to_mm"));
  edit.reach_mm = json.value("reach_mm", 0.0);
  return edit;
}

Json to_json(const ViewCamera& camera) {
  return {{"position_mm", numbers<3>(camera.position_mm)},
          {"focal_mm", numbers<3>(camera.focal_mm)},
          {"up", numbers<3>(camera.up)},
          {"height_mm", camera.height_mm}};
}

ViewCamera camera_from(const Json& json) {
  ViewCamera camera;
  camera.position_mm = vector_from<3>(json.at("position_mm"));
  camera.focal_mm = vector_from<3>(json.at("focal_mm"));
  camera.up = vector_from<3>(json.at("up"));
  camera.height_mm = positive_from(json, "height_mm", 0, 1e9);
  if ((camera.position_mm - camera.focal_mm).cross(camera.up).norm() < 1e-9)
    refuse("the camera looks along its own up direction", json);
  return camera;
}

void read_layers(const Json& json, ViewLayers& layers) {
  layers.surfaces = json.value("surfaces", layers.surfaces);
  layers.contours = json.value("contours", layers.contours);
  layers.cut_lines = json.value("cut_lines", layers.cut_lines);
  layers.marks = json.value("marks", layers.marks);
  read_name(json, "images", image_names, layers.images);
}

void read_marks(const Json& json, ViewState& state) {
  for (const Json& pick : json.value("picks_mm", Json::array())) state.picks_mm.push_back(vector_from<3>(pick));
  for (const Json& one : json.value("measurements", Json::array()))
    state.measurements.push_back({vector_from<3>(one.at("from_mm")), vector_from<3>(one.at("to_mm"))});
  for (const Json& seed : json.value("seeds", Json::array()))
    state.seeds.push_back({vector_from<3>(seed.at("position_mm")), seed.value("name", "organ")});
}

Json marks_json(const ViewState& state) {
  Json json = {{"picks_mm", Json::array()}, {"measurements", Json::array()}, {"seeds", Json::array()}};
  for (const Eigen::Vector3d& pick : state.picks_mm) json["picks_mm"].push_back(numbers<3>(pick));
  for (const Measurement& one : state.measurements)
    json["measurements"].push_back(
        {{"from_mm", numbers<3>(one.from_mm)}, {"to_mm", numbers<3>(one.to_mm)}, {"length_mm", one.length_mm()}});
  for (const ViewSeed& seed : state.seeds)
    json["seeds"].push_back({{"position_mm", numbers<3>(seed.position_mm)}, {"name", seed.name}});
  return json;
}

}  // namespace

nlohmann::json to_json(const ViewState& state) {
  Json json = marks_json(state);
  json["plane"] = state.plane;
  json["layout"] = name_of(state.layout, layout_names);
  json["pointer"] = name_of(state.pointer, pointer_names);
  json["layers"] = {{"surfaces", state.layers.surfaces},
                    {"contours", state.layers.contours},
                    {"cut_lines", state.layers.cut_lines},
                    {"marks", state.layers.marks},
                    {"images", name_of(state.layers.images, image_names)}};
  json["clip"] = name_of(state.clip, clip_names);
  json["side_by_side"] = state.side_by_side;
  json["surface_opacity"] = state.surface_opacity;
  json["reach_mm"] = state.reach_mm;
  json["frame"] = state.frame;
  if (state.grey) json["grey"] = {{"low", state.grey->low}, {"high", state.grey->high}};
  if (state.camera) json["camera"] = to_json(*state.camera);
  json["is_segmented"] = state.is_segmented;
  json["is_solved"] = state.is_solved;
  json["edits"] = Json::array();
  for (const EditStep& step : state.edits) {
    Json& list = json["edits"].emplace_back(Json::array());
    for (const ContourEdit& edit : step) list.push_back(to_json(edit));
  }
  return json;
}

ViewState view_state_from(const nlohmann::json& json) {
  if (!json.is_object()) refuse("\"state\" is not an object", json);
  ViewState state;
  state.plane = index_from(json, "plane");
  read_name(json, "layout", layout_names, state.layout);
  read_name(json, "pointer", pointer_names, state.pointer);
  if (json.contains("layers")) read_layers(json["layers"], state.layers);
  read_name(json, "clip", clip_names, state.clip);
  state.side_by_side = json.value("side_by_side", false);
  state.surface_opacity = positive_from(json, "surface_opacity", state.surface_opacity, 1);
  state.reach_mm = positive_from(json, "reach_mm", state.reach_mm, 1e6);
  state.frame = index_from(json, "frame");
  if (json.contains("grey"))
    state.grey = GreyWindow{json["grey"].at("low").get<float>(), json["grey"].at("high").get<float>()};
  if (json.contains("camera")) state.camera = camera_from(json["camera"]);
  read_marks(json, state);
  state.is_segmented = json.value("is_segmented", false);
  state.is_solved = json.value("is_solved", false);
  for (const Json& step : json.value("edits", Json::array())) {
    EditStep& edits = state.edits.emplace_back();
    for (const Json& edit : step) edits.push_back(edit_from(edit));
  }
  return state;
}

}  // namespace isostack
