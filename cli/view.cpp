#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"
#include "io/contours/contour_files.h"
#include "io/formats.h"
#include "io/meshes/read_mesh.h"
#include "io/read_slices.h"
#include "viewers/screenshot.h"

namespace isostack::cli {

namespace {

struct ViewCommand {
  std::vector<std::filesystem::path> paths;
  std::filesystem::path screenshot;
  std::string title;
  std::vector<int> size = {1200, 900};
  std::vector<double> view_from;
  double opacity = 1;
  bool dark = false;
};

Scene read_scene(const ViewCommand& command, Session& session) {
  Scene scene;
  scene.title = command.title;
  for (const std::filesystem::path& path : command.paths) {
    // .vtp holds surfaces or contours; a surface is what most programs write.
    if (std::filesystem::is_regular_file(path) && holds_contours(path)) {
      ContourFile file = read_contour_file(path);
      for (const std::string& warning : file.warnings) session.note(warning);
      std::move(file.organs.begin(), file.organs.end(), std::back_inserter(scene.contours));
    } else if (find_format(path, &Format::read_mesh) != nullptr) {
      scene.surfaces.push_back(read_mesh(path));
    } else {
      SliceStack stack = read_slices(path, {}, session.progress());
      std::move(stack.slices.begin(), stack.slices.end(), std::back_inserter(scene.slices));
    }
  }
  return scene;
}

void run_view(const ViewCommand& command, Session& session) {
  const Scene scene = read_scene(command, session);
  ScreenshotOptions options;
  options.width_pixels = command.size[0];
  options.height_pixels = command.size[1];
  options.dark = command.dark;
  options.surface_opacity = command.opacity;
  if (!command.view_from.empty())
    options.view_from = {command.view_from[0], command.view_from[1], command.view_from[2]};
  save_screenshot(scene, command.screenshot, options);
  session.result["screenshot"] = command.screenshot.string();
  session.text = "wrote " + command.screenshot.string() + "\n";
}

}  // namespace

void add_view(CLI::App& app, Session& session) {
  auto options = std::make_shared<ViewCommand>();
  CLI::App* command = app.add_subcommand("view", "One picture of surfaces, contours and slices");
  command->add_option("IN", options->paths, "Surfaces, contours, images")->required();
  command->add_option("--screenshot", options->screenshot, "Write the picture here")->required()->type_name("FILE.png");
  command->add_option("--title", options->title, "Line at the top of the picture");
  command->add_option("--size", options->size, "Width and height in pixels")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(64, 8000))
      ->type_name("W,H");
  command->add_option("--view-from", options->view_from, "Direction from the scene to the camera, LPS")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,Z");
  command->add_option("--opacity", options->opacity, "Of surfaces; below 1 what is behind shows through")
      ->check(CLI::Range(0.05, 1.0));
  command->add_flag("--dark", options->dark, "Dark background");
  command->callback([options, &session] { session.run = [options, &session] { run_view(*options, session); }; });
}

}  // namespace isostack::cli
