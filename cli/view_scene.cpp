#include "cli/view_scene.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <set>

#include "cli/body_inputs.h"
#include "cli/label_inputs.h"
#include "cli/path_roles.h"
#include "io/contours/contour_files.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "io/meshes/read_mesh.h"
#include "io/read_slices.h"
#include "io/solid_file.h"
#include "recon/geometry/errors.h"
#include "viewers/scene_points.h"
#include "viewers/scene_title.h"
#include "viewers/scene_warnings.h"
#include "viewers/surface_values.h"
#include "viewers/view_planes.h"

namespace isostack::cli {

namespace {

namespace fs = std::filesystem;

MeshAxes axes_of(const ViewInput& options) { return options.input_axes == "ras" ? MeshAxes::ras : MeshAxes::lps; }

/// Adds what the input holds; returns what it is called in the title.
std::string read_into(Scene& scene, const fs::path& path, const ViewInput& options, Session& session) {
  require_exists(path);
  const bool is_file = fs::is_regular_file(path);
  // .json holds solids or contours, .vtp contours or surfaces.
  if (is_file && (holds_solid(path) || is_distance_volume(path, {}))) {
    scene.surfaces.push_back({.mesh = *read_body(path, {}, session)});
  } else if (is_file && holds_contours(path)) {
    ContourFile file = read_contour_file(path, options.input.read_options());
    for (const std::string& warning : file.warnings) session.note(warning);
    for (ContourStack& organ : file.organs) scene.contours.push_back({.stack = std::move(organ)});
  } else if (find_format(path, &Format::read_mesh) != nullptr) {
    scene.surfaces.push_back({.mesh = read_mesh(path, axes_of(options))});
  } else if (is_file && holds_named_organs(path)) {
    InputOptions labels = options.input;
    labels.paths = {path};
    for (ContourStack& organ : organs_in_labels(labels, session)) scene.contours.push_back({.stack = std::move(organ)});
  } else {
    SliceStack stack = read_slices(path, options.input.read_options(), session.progress());
    for (const std::string& warning : stack.warnings) session.note(warning);
    for (Slice& slice : stack.slices) scene.slices.push_back({.image = std::move(slice)});
    if (fs::is_directory(path)) return stack.name;  // a folder may be called after the patient
  }
  return path.filename().string();
}

/// The middle plane of each direction.
std::set<std::size_t> middle_slices(const Scene& scene) {
  std::vector<std::vector<std::size_t>> families;
  for (const ViewPlane& plane : view_planes(scene)) {
    if (!plane.image) continue;
    families.resize(std::max(families.size(), plane.family + 1));
    families[plane.family].push_back(*plane.image);
  }
  std::set<std::size_t> middle;
  for (const std::vector<std::size_t>& family : families)
    if (!family.empty()) middle.insert(family[family.size() / 2]);
  return middle;
}

std::set<std::size_t> numbered_slices(const std::string& list, std::size_t count) {
  std::set<std::size_t> numbers;
  for (const std::string& text : CLI::detail::split(list, ',')) {
    std::size_t number = 0;
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data(), end, number).ptr != end || text.empty())
      throw InputError("--slices", "'" + text + "' is no slice number",
                       "give all, none, middle, or numbers such as 0,5");
    if (number >= count)
      throw InputError("--slices", fmt::format("there is no slice {} among the {}", number, count),
                       "number the slices from 0");
    numbers.insert(number);
  }
  return numbers;
}

void choose_slices(Scene& scene, const ViewInput& options) {
  std::string choice = options.slices;
  if (choice.empty()) choice = scene.surfaces.empty() && scene.contours.empty() ? "all" : "middle";
  std::set<std::size_t> shown;
  if (choice == "middle")
    shown = middle_slices(scene);
  else if (choice != "all" && choice != "none")
    shown = numbered_slices(choice, scene.slices.size());
  for (std::size_t i = 0; i < scene.slices.size(); ++i) {
    scene.slices[i].visible = choice == "all" || shown.contains(i);
    scene.slices[i].opacity = options.slice_opacity;
  }
}

/// The contours a surface is judged by: those of its name, or the only ones; else as many stacks as surfaces, in order.
const ContourStack& contours_for(std::size_t surface, const Scene& scene) {
  if (scene.contours.empty())
    throw InputError("--colour residual", "there are no contours", "give the contours the surface was made of");
  for (const SceneContours& organ : scene.contours)
    if (!organ.stack.name.empty() && organ.stack.name == scene.surfaces[surface].mesh.name) return organ.stack;
  return scene.contours[std::min(surface, scene.contours.size() - 1)].stack;
}

VertexValues values_of(std::size_t index, const Scene& scene, const ViewInput& options, const TriangleMesh& against) {
  const TriangleMesh& mesh = scene.surfaces[index].mesh;
  if (options.colour == "curvature") return curvature_values(mesh);
  if (options.colour == "residual") return residual_values(mesh, contours_for(index, scene));
  return distance_values(mesh, against, options.against.filename().string());
}

void colour_surfaces(Scene& scene, const ViewInput& options) {
  for (SceneSurface& surface : scene.surfaces) {
    surface.opacity = options.opacity;
    surface.style = options.style == "wire" ? SurfaceStyle::wire : SurfaceStyle::shaded;
  }
  if (options.colour == "label") return;
  require_drawable(scene);  // values of broken meshes mean nothing
  TriangleMesh against;
  if (options.colour == "distance") {
    if (options.against.empty())
      throw InputError("--colour distance", "it does not say to what", "name the other surface with --against");
    against = read_mesh(options.against, axes_of(options));
  }
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    VertexValues values = values_of(i, scene, options, against);
    if (!options.colour_range.empty())
      values.range = {.low = options.colour_range[0],
                      .high = options.colour_range[1],
                      .map = options.colour_range[0] < 0 ? ColourMap::diverging : ColourMap::sequential};
    scene.surfaces[i].values = std::move(values);
  }
}

/// One bar for all surfaces: the widest of their automatic ranges.
void share_range(Scene& scene) {
  std::optional<ColourRange> widest;
  for (const SceneSurface& surface : scene.surfaces)
    if (surface.values && (!widest || surface.values->range.high > widest->high)) widest = surface.values->range;
  for (SceneSurface& surface : scene.surfaces)
    if (surface.values) surface.values->range = *widest;
}

}  // namespace

void add_view_input(CLI::App& command, ViewInput& options) {
  command.add_option("IN", options.input.paths, "Surfaces, solids, distance volumes, contours, images")
      ->check(read_path())
      ->required();
  add_source_options(command, options.input);
  command
      .add_option("--spacing", options.input.spacing_mm, "Column, row and slice distance in mm of PNG or TIFF stacks")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::PositiveNumber)
      ->type_name("X,Y,Z");
  command.add_option("--input-axes", options.input_axes, "Axes of the surfaces that are read")
      ->check(CLI::IsMember({"lps", "ras"}));
  command
      .add_option_function<std::string>(
          "--title",
          [&options](const std::string& title) {
            options.title = title;
            options.has_title = true;
          },
          "Instead of the files' names and key numbers; may be empty")
      ->type_name("TEXT");
  command
      .add_option("--slices", options.slices, "Images to show: all, none, middle (one of each direction), or numbers")
      ->type_name("all|none|middle|I[,I...]");
  command.add_option("--opacity", options.opacity, "Of surfaces; below 1 what is behind shows through")
      ->check(CLI::Range(0.05, 1.0));
  command.add_option("--slice-opacity", options.slice_opacity, "Of images")->check(CLI::Range(0.05, 1.0));
  command.add_option("--style", options.style, "Of surfaces")->check(CLI::IsMember({"shaded", "wire"}));
  command.add_option("--colour,--color", options.colour, "What colours show on surfaces")
      ->check(CLI::IsMember({"label", "residual", "distance", "curvature"}));
  command.add_option("--against", options.against, "The other surface for --colour distance")
      ->check(read_path())
      ->type_name("FILE");
  command.add_option("--colour-range,--color-range", options.colour_range, "Values of the first and last colour")
      ->delimiter(',')
      ->expected(2)
      ->type_name("LOW,HIGH");
}

Scene read_view_scene(const ViewInput& options, Session& session) {
  Scene scene;
  std::vector<std::string> names;
  for (const fs::path& path : options.input.paths) names.push_back(read_into(scene, path, options, session));
  choose_slices(scene, options);
  colour_surfaces(scene, options);
  if (options.colour_range.empty()) share_range(scene);
  require_drawable(scene);
  for (const std::string& warning : scene_warnings(scene)) session.note(warning);
  scene.title = options.has_title ? options.title : title_of(scene, names);
  return scene;
}

}  // namespace isostack::cli
