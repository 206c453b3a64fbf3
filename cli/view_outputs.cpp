#include "cli/view_outputs.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "cli/path_roles.h"
#include "io/atomic_folder.h"
#include "io/images/write_pictures.h"
#include "recon/geometry/errors.h"
#include "viewers/camera_presets.h"
#include "viewers/contradiction_picture.h"
#include "viewers/montage.h"
#include "viewers/page/page.h"

namespace isostack::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* frame_prefix = "frame_";

/// "1200x900" or "1200,900".
std::pair<int, int> size_of(const std::string& text) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  const bool has_second = first.ptr != end && (*first.ptr == 'x' || *first.ptr == ',');
  if (!has_second || std::from_chars(first.ptr + 1, end, height).ptr != end || height == 0)
    throw InputError("--size", "'" + text + "' is no size", "give width and height in pixels such as 1200x900");
  return {width, height};
}

bool is_gif(const fs::path& path) { return path.extension() == ".gif"; }
bool is_png(const fs::path& path) { return path.extension() == ".png"; }

void require_folder_of(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (!fs::is_directory(folder))
    throw InputError(path.string(), "its folder does not exist", "create " + folder.string());
}

void write_turntable(const std::vector<Picture>& pictures, const fs::path& path, double frames_per_second) {
  if (is_gif(path)) return write_gif(pictures, path, {.frames_per_second = frames_per_second});
  AtomicFolder folder(path, frame_prefix);
  for (std::size_t i = 0; i < pictures.size(); ++i)
    write_png(pictures[i], folder.temporary() / fmt::format("{}{:03}.png", frame_prefix, i));
  folder.commit();
}

void write_contradiction(const Scene& scene, const fs::path& path, const ScreenshotOptions& options, Session& session) {
  const std::optional<ContradictingPair> worst = worst_pair(scene);
  if (!worst)
    throw InputError("--contradiction", "no two slices contradict each other",
                     "nothing needs to be shown; leave the option out");
  nlohmann::json places = nlohmann::json::array();
  for (const Contradiction& place : worst->pair.places) {
    const Eigen::Vector3d middle = place.middle_mm();
    places.push_back({{"middle_mm", {middle.x(), middle.y(), middle.z()}},
                      {"length_mm", place.length_mm},
                      {"distance_mm", place.distance_mm}});
  }
  session.result["contradiction"] = {{"organ", scene.contours[worst->organ].stack.name},
                                     {"first", worst->pair.first_name},
                                     {"second", worst->pair.second_name},
                                     {"largest_mismatch_mm", worst->pair.largest_mismatch_mm},
                                     {"places", places}};
  session.text += fmt::format("{} and {} contradict each other by up to {:.2f} mm\n", worst->pair.first_name,
                              worst->pair.second_name, worst->pair.largest_mismatch_mm);
  write_png(draw_contradiction(scene, *worst, options), path);
}

void write_picture(const Scene& scene, const ViewOutputs& outputs, Session& session) {
  const ScreenshotOptions options = outputs.picture_options();
  const fs::path& path = outputs.screenshot;
  if (outputs.turntable > 0)
    write_turntable(draw_turntable(scene, outputs.turntable, options, session.progress()), path,
                    outputs.frames_per_second);
  else if (outputs.montage)
    write_png(
        draw_montage(scene, {.width_pixels = options.width_pixels, .dark = outputs.dark, .grey = options.look.grey},
                     session.progress()),
        path);
  else if (outputs.contradiction)
    write_contradiction(scene, path, options, session);
  else
    save_screenshot(scene, path, options);
  session.result["screenshot"] = path.string();
}

}  // namespace

ScreenshotOptions ViewOutputs::picture_options() const {
  ScreenshotOptions options;
  std::tie(options.width_pixels, options.height_pixels) = size_of(size);
  options.look.dark = dark;
  options.look.axes = axes;
  options.look.marks = !no_marks;
  if (!camera.empty()) options.look.view_from = camera_direction(camera);
  if (!view_from.empty()) options.look.view_from = {view_from[0], view_from[1], view_from[2]};
  if (!window_level.empty()) options.look.grey = grey_window_from(window_level[0], window_level[1]);
  return options;
}

void add_view_outputs(CLI::App& command, ViewOutputs& options) {
  auto* screenshot = command.add_option("--screenshot", options.screenshot, "Write a picture here")
                         ->check(written_path())
                         ->type_name("FILE.png");
  auto* turntable = command
                        .add_option("--turntable", options.turntable,
                                    "N pictures of one turn; --screenshot is a .gif or a folder of PNGs")
                        ->check(CLI::Range(2, 720))
                        ->needs(screenshot)
                        ->type_name("N");
  command.add_option("--fps", options.frames_per_second, "Pictures per second of a .gif")
      ->check(CLI::Range(0.1, 50.0))
      ->needs(turntable);
  auto* montage = command.add_flag("--montage", options.montage, "Instead all slices with contours and cut surfaces")
                      ->needs(screenshot)
                      ->excludes(turntable);
  command
      .add_flag("--contradiction", options.contradiction,
                "Instead the two slices whose contours contradict each other most, and by how many mm")
      ->needs(screenshot)
      ->excludes(turntable)
      ->excludes(montage);
  command.add_option("--html", options.html, "Write a page to share: one file, opened in any browser")
      ->check(written_path())
      ->type_name("FILE.html");
  command.add_option("--size", options.size, "Width and height of pictures in pixels")->type_name("WxH");
  auto* camera = command.add_option("--camera", options.camera, "Where the camera is");
  std::vector<std::string> names;
  for (const auto& [name, direction] : camera_presets()) names.push_back(name);
  camera->check(CLI::IsMember(names));
  command.add_option("--view-from", options.view_from, "Direction from the scene to the camera, LPS")
      ->delimiter(',')
      ->expected(3)
      ->excludes(camera)
      ->type_name("X,Y,Z");
  command.add_option("--window", options.window_level, "Grey values: width and middle of what is not black or white")
      ->delimiter(',')
      ->expected(2)
      ->type_name("W,L");
  auto* dark = command.add_flag("--dark", options.dark, "Dark background");
  command.add_flag("--light", options.light, "White background (default)")->excludes(dark);
  command.add_flag("--axes", options.axes, "Box with mm along the patient's directions");
  command.add_flag("--no-marks", options.no_marks, "Without scale bar and cube");
}

void require_writable(const ViewOutputs& options) {
  for (const fs::path& path : {options.screenshot, options.html})
    if (!path.empty()) require_folder_of(path);
  if (!options.window_level.empty() && options.window_level[0] <= 0)
    throw InputError("--window", "its width is not positive", "give width and middle such as 400,40");
  options.picture_options();
  const fs::path& path = options.screenshot;
  if (path.empty()) return;
  if (options.turntable == 0 && !is_png(path))
    throw InputError(path.string(), "pictures are written as PNG", "end its name in .png");
  if (options.turntable == 0 || is_gif(path)) return;
  if (path.has_extension())
    throw InputError(path.string(), "a turntable is a .gif or a folder",
                     "end its name in .gif or leave the ending out");
  AtomicFolder::require_replaceable(path, frame_prefix);
}

void write_view_outputs(const Scene& scene, const ViewOutputs& options, Session& session) {
  if (!options.screenshot.empty()) {
    write_picture(scene, options, session);
    session.wrote(options.screenshot);
  }
  if (!options.html.empty()) {
    const ScreenshotOptions look = options.picture_options();
    save_page(scene, options.html, {.dark = options.dark, .view_from = look.look.view_from, .grey = look.look.grey});
    session.wrote(options.html);
  }
}

}  // namespace isostack::cli
