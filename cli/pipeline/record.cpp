#include "cli/pipeline/record.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <set>

#include "cli/option_values.h"
#include "cli/path_roles.h"
#include "cli/pipeline/content_hash.h"
#include "cli/pipeline/pipeline.h"
#include "cli/pipeline/step_paths.h"

namespace isostack::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Recipes are resolved and help is no option of a run.
bool is_recorded(const CLI::Option& option) {
  const std::set<std::string> others = {"help", "recipe", "save-recipe"};
  return !others.contains(option_key(option));
}

/// Letters, digits, dashes and underscores of a file's name without its extension.
std::string name_from(const std::string& path) {
  std::string stem = std::filesystem::path(path).lexically_normal().filename().string();
  if (stem.empty()) stem = std::filesystem::path(path).lexically_normal().parent_path().filename().string();
  std::string name;
  for (const char c : stem.substr(0, stem.find('.', 1)))
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' ? c : '_';
  return name.empty() ? "input" : name;
}

template <class IsTaken>
std::string unique_name(const std::string& name, IsTaken is_taken) {
  if (!is_taken(name)) return name;
  for (int i = 2;; ++i)
    if (std::string other = name + "-" + std::to_string(i); !is_taken(other)) return other;
}

class Recorder {
 public:
  Recorder(Pipeline& pipeline, const PipelineStep& step) : pipeline_(pipeline), step_(step) {}

  /// A path that another step writes stays; any other becomes an input.
  std::string reference(const std::string& path) {
    for (const PipelineStep& other : pipeline_.steps)
      if (writes_path(other, path)) return path;
    const std::string hash = content_hash(path, {step_.writes.begin(), step_.writes.end()});
    for (auto& [name, input] : pipeline_.inputs)
      if (is_same_path(input.path, path)) {
        input.sha256 = hash;
        return "@" + name;
      }
    const std::string name =
        unique_name(name_from(path), [&](const std::string& n) { return pipeline_.inputs.contains(n); });
    pipeline_.inputs[name] = {path, hash};
    return "@" + name;
  }

  Json recorded(const CLI::Option& option) {
    const std::optional<PathRole> role = path_role(option);
    if (!role) return json_of(option);
    Json paths = Json::array();
    for (const std::string& path : option.results()) paths.push_back(*role == PathRole::kRead ? reference(path) : path);
    return paths.size() == 1 && option.get_expected_max() == 1 ? paths.front() : paths;
  }

 private:
  Pipeline& pipeline_;
  const PipelineStep& step_;
};

/// Puts the step where one that wrote the same stood, else at the end.
void add_step(Pipeline& pipeline, PipelineStep step) {
  const auto same = std::find_if(pipeline.steps.begin(), pipeline.steps.end(), [&](const PipelineStep& other) {
    return other.command == step.command && !step.writes.empty() && other.writes == step.writes;
  });
  if (same != pipeline.steps.end()) {
    step.name = same->name;
    *same = std::move(step);
    return;
  }
  step.name = unique_name(step.command, [&](const std::string& name) {
    return std::any_of(pipeline.steps.begin(), pipeline.steps.end(), [&](const auto& s) { return s.name == name; });
  });
  pipeline.steps.push_back(std::move(step));
}

void drop_unused_inputs(Pipeline& pipeline) {
  std::set<std::string> used;
  for (const PipelineStep& step : pipeline.steps)
    for (const Json& value : step.options)
      for (const Json& text : value.is_array() ? value : Json::array({value}))
        if (text.is_string()) used.insert(input_name(text));
  std::erase_if(pipeline.inputs, [&](const auto& input) { return !used.contains(input.first); });
}

}  // namespace

void record_step(const CLI::App& command, const std::vector<std::string>& written, const std::filesystem::path& file) {
  Pipeline pipeline;
  if (std::filesystem::exists(file)) pipeline = read_pipeline(file);
  pipeline.isostack = ISOSTACK_VERSION;
  PipelineStep step{"", command.get_name(), Json::object(), Json::object(), written, ""};
  Recorder recorder(pipeline, step);
  Json options = Json::object();
  for (const CLI::Option* option : command.get_options()) {
    if (!is_recorded(*option)) continue;
    if (option->count() > 0)
      options[option_key(*option)] = recorder.recorded(*option);
    else if (!option->get_default_str().empty())
      step.defaults[option_key(*option)] = number_or_text(option->get_default_str());
  }
  step.options = std::move(options);
  add_step(pipeline, std::move(step));
  drop_unused_inputs(pipeline);
  write_pipeline(pipeline, file);
}

}  // namespace isostack::cli
