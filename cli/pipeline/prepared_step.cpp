#include "cli/pipeline/prepared_step.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/option_values.h"
#include "cli/path_roles.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

const CLI::Option* find_option(const CLI::App& command, const std::string& key) {
  for (const CLI::Option* option : command.get_options())
    if (option_key(*option) == key) return option;
  return nullptr;
}

/// The option as arguments: `--key value` for each value, or the values alone.
void append_arguments(const CLI::Option& option, const nlohmann::ordered_json& value, const std::string& where,
                      const std::map<std::string, PipelineInput>& inputs, std::vector<std::string>& arguments) {
  if (value == false) return;
  const std::optional<std::vector<std::string>> texts = argument_values(value);
  if (!texts)
    throw InputError(where, "the value of '" + option_key(option) + "' is no number, text, true or array of these",
                     "write it as --record does");
  const bool is_path = path_role(option) == PathRole::kRead;
  for (const std::string& text : *texts) {
    const std::string name = is_path ? input_name(text) : "";
    if (!option.get_lnames().empty()) arguments.push_back("--" + option.get_lnames().front());
    if (!is_flag(option)) arguments.push_back(name.empty() ? text : inputs.at(name).path);
  }
}

}  // namespace

PreparedStep prepared(const PipelineStep& step, const AddCommands& add_commands, const Session& session) {
  PreparedStep result{&step, std::make_unique<Session>(), std::make_unique<CLI::App>(), nullptr};
  result.session->quiet = session.quiet;
  result.session->threads = session.threads;
  add_commands(*result.app, *result.session);
  for (CLI::App* command : result.app->get_subcommands([](CLI::App*) { return true; }))
    if (command->get_name() == step.command) result.command = command;
  if (!result.command || step.command == "run")
    throw InputError(step.where, "there is no command '" + step.command + "' to run", "see `isostack --help`");
  for (const auto& [key, value] : step.options.items())
    if (!find_option(*result.command, key))
      throw InputError(step.where, "'" + key + "' is no option of " + step.command,
                       "see `isostack " + step.command + " --help`");
  return result;
}

void parse_arguments(PreparedStep& prepared, const std::map<std::string, PipelineInput>& inputs) {
  const PipelineStep& step = *prepared.step;
  std::vector<std::string> arguments = {step.command};
  for (const bool named : {false, true})  // an option with several values would swallow what has no name
    for (const auto& [key, value] : step.options.items()) {
      const CLI::Option& option = *find_option(*prepared.command, key);
      if (option.get_lnames().empty() != named) append_arguments(option, value, step.where, inputs, arguments);
    }
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  try {
    prepared.app->parse(arguments);
  } catch (const CLI::ParseError& error) {
    throw InputError(step.where, std::string("the command refuses its options (") + error.what() + ")",
                     "see `isostack " + step.command + " --help`");
  }
}

std::vector<std::string> changed_defaults(const PreparedStep& prepared) {
  std::vector<std::string> changed;
  for (const auto& [key, recorded] : prepared.step->defaults.items()) {
    const CLI::Option* option = find_option(*prepared.command, key);
    if (!option)
      changed.push_back("there is no option '" + key + "' any more");
    else if (option->count() == 0 && number_or_text(option->get_default_str()) != recorded)
      changed.push_back("the default of '" + key + "' was " + recorded.dump() + " and is " + option->get_default_str() +
                        " now");
  }
  return changed;
}

}  // namespace isostack::cli
