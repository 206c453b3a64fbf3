#include "cli/pipeline/run_pipeline.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/path_roles.h"
#include "cli/pipeline/content_hash.h"
#include "cli/pipeline/prepared_step.h"
#include "cli/pipeline/run_state.h"
#include "cli/pipeline/step_order.h"
#include "cli/pipeline/step_paths.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"

namespace isostack::cli {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void replace_inputs(Pipeline& pipeline, const std::map<std::string, std::string>& paths, const fs::path& file) {
  for (const auto& [name, path] : paths) {
    const auto input = pipeline.inputs.find(name);
    if (input == pipeline.inputs.end()) {
      std::string names;
      for (const auto& [known, unused] : pipeline.inputs) names += (names.empty() ? "" : ", ") + known;
      throw InputError(file.string(), "it has no input named '" + name + "'", "its inputs are: " + names);
    }
    input->second = {path, ""};
  }
}

/// Every path of the step's options, as a reference to be changed.
template <class Function>
void for_each_path(PipelineStep& step, const CLI::App& command, Function&& function) {
  for (const CLI::Option* option : command.get_options()) {
    const auto value = step.options.find(option_key(*option));
    const std::optional<PathRole> role = path_role(*option);
    if (value == step.options.end() || !role) continue;
    if (!value->is_array()) *value = Json::array({*value});
    for (Json& path : *value)
      if (path.is_string()) path = function(path.get<std::string>(), *role);
  }
}

/// Steps written by hand need not tell what they write.
void fill_in_writes(PipelineStep& step, const CLI::App& command) {
  if (!step.writes.empty()) return;
  for_each_path(step, command, [&](const std::string& path, PathRole role) {
    if (role == PathRole::kWritten) step.writes.push_back(path);
    return path;
  });
}

void move_outputs(Pipeline& pipeline, const std::vector<PreparedStep>& commands, const fs::path& folder) {
  const auto moved = [&](const std::string& path) {
    return (folder / (fs::path(path).is_absolute() ? fs::path(path).filename() : fs::path(path))).string();
  };
  const auto is_written = [steps = pipeline.steps](const std::string& path) {
    return std::any_of(steps.begin(), steps.end(), [&](const PipelineStep& step) { return writes_path(step, path); });
  };
  for (std::size_t i = 0; i < pipeline.steps.size(); ++i) {
    PipelineStep& step = pipeline.steps[i];
    for_each_path(step, *commands[i].command, [&](const std::string& path, PathRole role) {
      return role == PathRole::kWritten || is_written(path) ? moved(path) : path;
    });
    for (std::string& path : step.writes) path = moved(path);
  }
}

void make_output_folders(const Pipeline& pipeline) {
  for (const PipelineStep& step : pipeline.steps)
    for (const fs::path path : step.writes)
      if (path.has_parent_path()) fs::create_directories(path.parent_path());
}

/// Everything the steps read from outside must be there before the first of them runs.
void require_inputs(const Pipeline& pipeline, const std::vector<std::vector<std::string>>& reads) {
  for (std::size_t i = 0; i < reads.size(); ++i)
    for (const std::string& text : reads[i]) {
      const std::string name = input_name(text);
      const std::string path = name.empty() ? text : pipeline.inputs.at(name).path;
      const bool is_written = name.empty() && std::any_of(pipeline.steps.begin(), pipeline.steps.end(),
                                                          [&](const PipelineStep& s) { return writes_path(s, path); });
      if (!is_written && !fs::exists(path))
        throw InputError(pipeline.steps[i].where,
                         "step '" + pipeline.steps[i].name + "' reads " + path + ", which is not there",
                         name.empty() ? "correct the path" : "give it with --input " + name + "=PATH");
    }
}

class Runner {
 public:
  Runner(const Pipeline& pipeline, const PipelineRunOptions& options, fs::path state_file, Session& session)
      : pipeline_(pipeline), options_(options), state_(std::move(state_file)), session_(session) {}

  void run(std::vector<PreparedStep>& steps, const std::vector<std::size_t>& order,
           const std::vector<std::vector<std::string>>& reads) {
    session_.result["steps"] = nlohmann::json::array();
    for (const std::size_t i : order) run_step(steps[i], reads[i]);
  }

 private:
  /// A dry run cannot know the content of what earlier steps would write anew: then they wait for them.
  void run_step(PreparedStep& prepared, const std::vector<std::string>& reads) {
    const PipelineStep& step = *prepared.step;
    const bool waits = std::any_of(reads.begin(), reads.end(), [&](const std::string& path) {
      return std::any_of(pending_.begin(), pending_.end(),
                         [&](const auto* other) { return writes_path(*other, path); });
    });
    const std::string key = waits ? "" : key_of(prepared, reads);
    const bool current = !waits && !options_.force && state_.is_current(step.name, key);
    if (current) return tell(prepared, "kept", 0, state_.written(step.name));
    if (options_.dry_run) {
      pending_.push_back(&step);
      return tell(prepared, "would run", 0, step.writes);
    }
    for (const std::string& remark : changed_defaults(prepared)) session_.note(step.name + ": " + remark);
    state_.forget(step.name);
    const Stopwatch stopwatch;
    try {
      prepared.session->run();
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception&) {
      session_.note("step '" + step.name + "' failed (" + step.where + ")");
      throw;
    }
    const std::vector<std::string> written = prepared.session->written();
    state_.remember(step.name, key, written);
    tell(prepared, "ran", stopwatch.seconds(), written);
  }

  std::string key_of(const PreparedStep& prepared, const std::vector<std::string>& reads) const {
    const PipelineStep& step = *prepared.step;
    const nlohmann::json sorted = nlohmann::json::parse(step.options.dump());  // their order means nothing
    std::string text = std::string(ISOSTACK_VERSION) + "\n" + step.command + "\n" + sorted.dump() + "\n";
    for (const std::string& path : reads) {
      const std::string name = input_name(path);
      text +=
          content_hash(name.empty() ? path : pipeline_.inputs.at(name).path, {step.writes.begin(), step.writes.end()});
      text += "\n";
    }
    return sha256_of(text);
  }

  void tell(const PreparedStep& prepared, const std::string& state, double seconds,
            const std::vector<std::string>& written) {
    nlohmann::json entry = {{"name", prepared.step->name},
                            {"command", prepared.step->command},
                            {"state", state},
                            {"seconds", seconds},
                            {"outputs", written}};
    if (state == "ran") entry["result"] = prepared.session->result;
    session_.result["steps"].push_back(entry);
    session_.text += fmt::format("{}: {}\n", prepared.step->name, state);
    session_.text += prepared.session->text;
  }

  const Pipeline& pipeline_;
  const PipelineRunOptions& options_;
  RunState state_;
  Session& session_;
  std::vector<const PipelineStep*> pending_;
};

}  // namespace

void run_pipeline(const fs::path& file, const PipelineRunOptions& options, const AddCommands& add_commands,
                  Session& session) {
  Pipeline pipeline = read_pipeline(file);
  replace_inputs(pipeline, options.inputs, file);
  std::vector<PreparedStep> steps;
  for (const PipelineStep& step : pipeline.steps) steps.push_back(prepared(step, add_commands, session));
  for (std::size_t i = 0; i < steps.size(); ++i) fill_in_writes(pipeline.steps[i], *steps[i].command);
  if (!options.output_folder.empty()) move_outputs(pipeline, steps, options.output_folder);
  std::vector<std::vector<std::string>> reads;
  for (const PreparedStep& step : steps) reads.push_back(paths_read(*step.step, *step.command));
  const std::vector<std::size_t> order = step_order(pipeline, reads);
  require_inputs(pipeline, reads);
  for (PreparedStep& step : steps) parse_arguments(step, pipeline.inputs);
  if (!options.dry_run) make_output_folders(pipeline);
  fs::path state = options.output_folder.empty() ? file : options.output_folder / file.filename();
  state += ".state.json";
  Runner(pipeline, options, state, session).run(steps, order, reads);
}

}  // namespace isostack::cli
