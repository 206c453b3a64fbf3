#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/path_roles.h"
#include "cli/pipeline/run_pipeline.h"
#include "cli/recipe.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

struct RunCommand {
  std::string file;
  std::vector<std::string> inputs;  ///< NAME=PATH
  PipelineRunOptions pipeline;
};

/// A recipe is one command that always runs.
void run_recipe(const std::string& name, CLI::App& app, Session& session) {
  std::vector<std::string> arguments = arguments_of(read_recipe(name), name);
  if (arguments.front() == "run") throw InputError("recipe " + name, "it runs itself", "name another command in it");
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  try {
    app.parse(arguments);  // sets session.run
  } catch (const CLI::ParseError& error) {
    throw InputError("recipe " + name, std::string("its command line is refused (") + error.what() + ")",
                     "compare it with `" + arguments.back() + " --help`");
  }
  const std::function<void()> run = session.run;
  run();
}

void run(RunCommand& command, CLI::App& app, Session& session) {
  if (is_recipe(command.file)) return run_recipe(command.file, app, session);
  for (const std::string& input : command.inputs) {
    const std::size_t equals = input.find('=');
    command.pipeline.inputs[input.substr(0, equals)] = input.substr(equals + 1);
  }
  run_pipeline(command.file, command.pipeline, add_commands, session);
}

}  // namespace

void add_run(CLI::App& app, Session& session) {
  auto options = std::make_shared<RunCommand>();
  CLI::App* command = app.add_subcommand("run", "Recorded commands again: only what has changed since");
  command->add_option("FILE", options->file, "Pipeline that --record wrote, or recipe of --save-recipe")
      ->required()
      ->check(read_path())
      ->type_name("FILE");
  command
      ->add_option("--input", options->inputs, "Another file or folder for an input of the pipeline (may be repeated)")
      ->allow_extra_args(false)
      ->type_name("NAME=PATH")
      ->check([](const std::string& text) {
        return text.find('=') > 0 && text.find('=') < text.size() - 1 ? "" : "expected NAME=PATH";
      });
  command->add_option("--output-dir", options->pipeline.output_folder, "Folder for everything that is written")
      ->check(written_path())
      ->type_name("DIR");
  command->add_flag("--force", options->pipeline.force, "Also what has not changed");
  command->add_flag("--dry-run", options->pipeline.dry_run, "Only tell what would run");
  command->callback(
      [options, &app, &session] { session.run = [options, &app, &session] { run(*options, app, session); }; });
}

}  // namespace isostack::cli
