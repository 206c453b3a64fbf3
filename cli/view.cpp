#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"
#include "cli/view_outputs.h"
#include "cli/view_scene.h"
#include "cli/view_window.h"

namespace isostack::cli {

namespace {

struct ViewCommand {
  ViewInput input;
  ViewOutputs outputs;
  ViewWindow window;
};

void run_view(const ViewCommand& command, Session& session) {
  if (!command.outputs.any()) {
    const ScreenshotOptions picture = command.outputs.picture_options();
    const WindowLook look{picture.width_pixels, picture.height_pixels, picture.look.dark};
    return open_view_window(command.input, command.window, look, session);
  }
  require_writable(command.outputs);
  write_view_outputs(read_view_scene(command.input, session), command.outputs, session);
}

}  // namespace

void add_view(CLI::App& app, Session& session) {
  auto options = std::make_shared<ViewCommand>();
  CLI::App* command = app.add_subcommand("view", "A window, pictures or a page of surfaces, contours and slices");
  add_view_input(*command, options->input);
  add_view_outputs(*command, options->outputs);
  add_view_window(*command, options->window);
  command->callback([options, &session] { session.run = [options, &session] { run_view(*options, session); }; });
}

}  // namespace isostack::cli
