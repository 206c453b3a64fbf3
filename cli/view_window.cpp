#include "cli/view_window.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "cli/interrupt.h"
#include "cli/path_roles.h"
#include "cli/progress_bar.h"
#include "io/formats.h"
#include "io/meshes/read_mesh.h"
#include "recon/geometry/errors.h"
#include "viewers/window/scene_window.h"
#include "viewers/window/view_session.h"

namespace isostack::cli {

namespace {

namespace fs = std::filesystem;

/// A folder of nothing but surfaces, such as `morph` writes, stands for them in the order of their names.
std::vector<fs::path> with_folders_opened(const std::vector<fs::path>& paths) {
  std::vector<fs::path> files;
  for (const fs::path& path : paths) {
    std::vector<fs::path> surfaces;
    if (fs::is_directory(path))
      for (const fs::directory_entry& entry : fs::directory_iterator(path))
        if (find_format(entry.path(), &Format::read_mesh)) surfaces.push_back(entry.path());
    std::sort(surfaces.begin(), surfaces.end());
    if (surfaces.empty()) surfaces.push_back(path);
    files.insert(files.end(), surfaces.begin(), surfaces.end());
  }
  return files;
}

/// Files with frames, so that a session can tell them from what does not change.
void part_frames(ViewSession& session) {
  const auto is_frame = [](const fs::path& path) { return find_format(path, &Format::read_mesh) != nullptr; };
  std::copy_if(session.inputs.begin(), session.inputs.end(), std::back_inserter(session.frames), is_frame);
  std::erase_if(session.inputs, is_frame);
}

ViewSession session_for(const ViewInput& input, const ViewWindow& options, const WindowLook& look) {
  if (is_session(input)) return read_view_session(input.input.paths.front());
  ViewSession session;
  session.inputs = with_folders_opened(input.input.paths);
  session.beside = options.beside;
  session.dark = look.dark;
  session.state.surface_opacity = input.opacity;
  if (input.has_title) session.title = input.title;
  if (options.are_frames) part_frames(session);
  return session;
}

WindowContent read_content(ViewInput input, const ViewWindow& options, const WindowLook& look, Session& session) {
  WindowContent content;
  content.session = session_for(input, options, look);
  content.session_file = options.session;
  if (content.session_file.empty())
    content.session_file = is_session(input) ? input.input.paths.front() : fs::path("isostack-view.json");
  content.picture_file = fs::path(content.session_file).replace_extension(".png");
  const ViewSession& known = content.session;
  input.input.paths = known.inputs;
  input.input.paths.insert(input.input.paths.end(), known.frames.begin(), known.frames.end());
  input.title = known.title;
  input.has_title = !known.title.empty();
  content.scene = read_view_scene(input, session);
  if (!known.frames.empty()) {
    for (SceneSurface& surface : content.scene.surfaces) content.frames.push_back(std::move(surface.mesh));
    content.scene.surfaces.clear();
    if (!input.has_title)
      content.scene.title = known.frames.front().filename().string() + " to " + known.frames.back().filename().string();
  }
  for (const fs::path& path : known.beside) content.beside.push_back(read_mesh(path));
  content.reconstruct = options.reconstruct;
  return content;
}

nlohmann::json to_json(const SceneWindowReport& report) {
  return {{"opened_ms", report.opened_ms},
          {"events", report.events},
          {"frames", report.frames},
          {"slowest_frame_ms", report.slowest_frame_ms},
          {"slowest_answer_ms", report.slowest_answer_ms},
          {"events_while_busy", report.events_while_busy},
          {"slowest_answer_while_busy_ms", report.slowest_answer_while_busy_ms},
          {"closing_ms", report.closing_ms}};
}

}  // namespace

void add_view_window(CLI::App& command, ViewWindow& options) {
  command.add_flag("--frames", options.are_frames, "Window: the surfaces are frames of a morph, in their order");
  command.add_option("--beside", options.beside, "Window: surfaces of a second result, seen from the same side")
      ->check(read_path())
      ->check(read_path())
      ->type_name("FILE...");
  command.add_option("--session", options.session, "Window: where Ctrl-S saves it (isostack-view.json)")
      ->check(written_path())
      ->type_name("FILE.json");
  command
      .add_option("--max-constraints", options.reconstruct.max_constraints,
                  "Window: edited contours are thinned to this many constraints")
      ->check(CLI::Range(12, 10'000'000));
  command
      .add_option("--resolution", options.reconstruct.resolution_mm,
                  "Window: edge in mm of cells of surfaces it solves")
      ->check(CLI::PositiveNumber);
}

bool is_session(const ViewInput& input) {
  return input.input.paths.size() == 1 && is_view_session(input.input.paths.front());
}

void open_view_window(ViewInput input, const ViewWindow& options, const WindowLook& look, Session& session) {
  WindowContent content = read_content(std::move(input), options, look, session);
  erase_progress();
  const SceneWindowReport report = open_scene_window(
      std::move(content),
      {.width_pixels = look.width_pixels, .height_pixels = look.height_pixels, .is_interrupted = interrupted});
  if (interrupted()) throw Cancelled();
  session.result["window"] = to_json(report);
  session.text += fmt::format("the window answered within {:.0f} ms\n", report.slowest_answer_ms);
}

}  // namespace isostack::cli
