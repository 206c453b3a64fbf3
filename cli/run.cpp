#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/recipe.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

void add_run(CLI::App& app, Session& session) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("run", "A command again, from the recipe it saved");
  command->add_option("RECIPE", *file, "File that --save-recipe wrote")->required()->type_name("FILE");
  command->callback([file, &app, &session] {
    session.run = [file, &app, &session] {
      const std::string name = *file;
      std::vector<std::string> arguments = arguments_of(read_recipe(name), name);
      if (arguments.front() == "run")
        throw InputError("recipe " + name, "it runs itself", "name another command in it");
      std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
      try {
        app.parse(arguments);  // sets session.run
      } catch (const CLI::ParseError& error) {
        throw InputError("recipe " + name, std::string("its command line is refused (") + error.what() + ")",
                         "compare it with `" + arguments.back() + " --help`");
      }
      const std::function<void()> run = session.run;
      run();
    };
  });
}

}  // namespace isostack::cli
