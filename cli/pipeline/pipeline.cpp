#include "cli/pipeline/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "cli/pipeline/located_json.h"
#include "io/atomic_file.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* pipeline_format = "isostack-pipeline";
constexpr int version = 1;

enum class Kind { kText, kNumber, kObject, kArray };

struct Key {
  std::string_view name;
  Kind kind;
  bool required;
};

bool has_kind(const Json& value, Kind kind) {
  return kind == Kind::kText     ? value.is_string()
         : kind == Kind::kNumber ? value.is_number()
         : kind == Kind::kObject ? value.is_object()
                                 : value.is_array();
}

/// Refuses what is not among the keys, has the wrong kind or is missing.
void require_keys(const LocatedJson& document, const std::string& pointer, std::initializer_list<Key> keys) {
  constexpr const char* remedy = "compare it with docs/schemas/pipeline.schema.json, or record it anew with --record";
  const Json& object = document.value.at(Json::json_pointer(pointer));
  if (!object.is_object()) throw InputError(document.where(pointer), "an object { } is expected here", remedy);
  for (const auto& [name, value] : object.items()) {
    const std::string place = fmt::format("{}/{}", pointer, name);
    const auto key = std::find_if(keys.begin(), keys.end(), [&, &n = name](const Key& k) { return k.name == n; });
    if (key == keys.end()) throw InputError(document.where(place), "the key '" + name + "' is unknown", remedy);
    if (!has_kind(value, key->kind))
      throw InputError(document.where(place), "the value of '" + name + "' is of another kind", remedy);
  }
  for (const Key& key : keys)
    if (key.required && !object.contains(key.name))
      throw InputError(document.where(pointer), "the key '" + std::string(key.name) + "' is missing", remedy);
}

PipelineStep step_at(const LocatedJson& document, std::size_t index) {
  const std::string pointer = "/steps/" + std::to_string(index);
  require_keys(document, pointer,
               {{"name", Kind::kText, true},
                {"command", Kind::kText, true},
                {"options", Kind::kObject, true},
                {"defaults", Kind::kObject, false},
                {"writes", Kind::kArray, false}});
  const Json& json = document.value["steps"][index];
  PipelineStep step{json["name"], json["command"],        json["options"], json.value("defaults", Json::object()),
                    {},           document.where(pointer)};
  for (const Json& path : json.value("writes", Json::array())) {
    if (!path.is_string()) throw InputError(document.where(pointer + "/writes"), "a path is expected", "write texts");
    step.writes.push_back(path);
  }
  return step;
}

void require_known_inputs(const Pipeline& pipeline, const LocatedJson& document) {
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i)
    for (const auto& [key, value] : pipeline.steps[i].options.items())
      for (const Json& text : value.is_array() ? value : Json::array({value})) {
        const std::string name = text.is_string() ? input_name(text) : "";
        if (!name.empty() && !pipeline.inputs.contains(name))
          throw InputError(document.where("/steps/" + std::to_string(i) + "/options/" + key),
                           "there is no input named '" + name + "'", "add it to \"inputs\"");
      }
}

void require_unique_names(const Pipeline& pipeline) {
  for (auto step = pipeline.steps.begin(); step != pipeline.steps.end(); ++step)
    if (std::any_of(pipeline.steps.begin(), step, [&](const PipelineStep& other) { return other.name == step->name; }))
      throw InputError(step->where, "two steps are named '" + step->name + "'", "rename one");
}

}  // namespace

std::string input_name(const std::string& text) { return text.starts_with('@') ? text.substr(1) : ""; }

Pipeline read_pipeline(const std::filesystem::path& file) {
  const LocatedJson document = read_located_json(file);
  const Json& json = document.value;
  if (!json.is_object() || !json.contains("format") || json["format"] != pipeline_format)
    throw InputError(file.string(), "it is not an isostack pipeline", "record one with `--record FILE` on any command");
  require_keys(document, "",
               {{"format", Kind::kText, true},
                {"version", Kind::kNumber, true},
                {"isostack", Kind::kText, false},
                {"inputs", Kind::kObject, true},
                {"steps", Kind::kArray, true}});
  if (json["version"] != version)
    throw InputError(document.where("/version"), "this program knows version 1 of pipelines only",
                     "use the isostack that recorded it");
  Pipeline pipeline{json.value("isostack", ""), {}, {}};
  for (const auto& [name, input] : json["inputs"].items()) {
    require_keys(document, "/inputs/" + name, {{"path", Kind::kText, true}, {"sha256", Kind::kText, false}});
    pipeline.inputs[name] = {input["path"], input.value("sha256", "")};
  }
  for (std::size_t i = 0; i < json["steps"].size(); ++i) pipeline.steps.push_back(step_at(document, i));
  require_unique_names(pipeline);
  require_known_inputs(pipeline, document);
  return pipeline;
}

void write_pipeline(const Pipeline& pipeline, const std::filesystem::path& file) {
  Json json = {{"format", pipeline_format}, {"version", version}, {"isostack", pipeline.isostack}};
  json["inputs"] = Json::object();
  for (const auto& [name, input] : pipeline.inputs) {
    json["inputs"][name] = {{"path", input.path}};
    if (!input.sha256.empty()) json["inputs"][name]["sha256"] = input.sha256;
  }
  json["steps"] = Json::array();
  for (const PipelineStep& step : pipeline.steps)
    json["steps"].push_back({{"name", step.name},
                             {"command", step.command},
                             {"options", step.options},
                             {"defaults", step.defaults},
                             {"writes", step.writes}});
  write_whole_file(file, json.dump(2) + "\n");
}

}  // namespace isostack::cli
