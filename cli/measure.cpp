#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <optional>

#include "cli/body_inputs.h"
#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/json_report.h"
#include "cli/label_inputs.h"
#include "cli/leave_out.h"
#include "cli/path_roles.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "io/meshes/read_mesh.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/overlap.h"
#include "recon/metrics/surface_distance.h"
#include "recon/metrics/voxel_surface.h"
#include "recon/metrics/voxelize.h"

namespace isostack::cli {

namespace {

struct MeasureCommand {
  InputOptions input;
  BodyOptions bodies;
  std::filesystem::path against;
  SurfaceDistanceOptions distance;
  std::string kernel;
  LeaveOutCommand leave_out;
};

/// A body (read_body), or a label volume (voxels of the chosen label, or all that are not 0) with its voxels' surface.
struct Shape {
  TriangleMesh mesh;
  MeshMeasures measures;
  std::optional<LabelVolume> labels;
};

/// The voxels of the organs that --label asks for, all without it, as 1.
LabelVolume read_voxels_of(const std::filesystem::path& path, const std::string& label) {
  const LabelMap map = read_labels(path);
  LabelVolume voxels(map.layers.front().grid);
  for (const Segment& segment : segments_asked_for(map, label.empty() ? "all" : label, path.string()))
    std::transform(map.layers[segment.layer].voxels.begin(), map.layers[segment.layer].voxels.end(),
                   voxels.voxels.begin(), voxels.voxels.begin(), [&](std::uint16_t value, std::uint16_t before) {
                     return static_cast<std::uint16_t>(value == segment.value ? 1 : before);
                   });
  return voxels;
}

Shape read_shape(const std::filesystem::path& path, const MeasureCommand& command, Session& session) {
  Shape shape;
  require_exists(path);
  std::optional<TriangleMesh> body = read_body(path, command.bodies, session);
  if (!body && find_format(path, &Format::read_mesh) != nullptr) body = read_mesh(path);  // throws: no mesh in it
  if (body) {
    shape.mesh = std::move(*body);
    shape.measures = measure(shape.mesh);
    return shape;
  }
  shape.labels = read_voxels_of(path, command.input.label);
  shape.mesh = voxel_surface(*shape.labels);
  if (shape.mesh.triangles.empty())
    throw InputError(path.string(), "no voxel has the label", "choose a label that is there");
  shape.measures = measure(shape.mesh);
  return shape;
}

void describe(const std::filesystem::path& path, const Shape& shape, const char* key, Session& session) {
  session.text += path.string() + "\n" + to_text(shape.measures);
  session.result[key] = to_json(shape.measures);
  if (!shape.measures.watertight())
    session.note(path.string() + " is not closed: its volume and overlap say little, and it has no genus");
  if (!shape.labels) return;
  const auto count = std::count_if(shape.labels->voxels.begin(), shape.labels->voxels.end(), [](auto v) { return v; });
  session.result[key]["voxels"] = count;
  session.text += fmt::format("  voxels      {} (the area is that of their faces)\n", count);
}

/// A cubic grid round both meshes with about 200 voxels along the diagonal.
Grid common_grid(const TriangleMesh& a, const TriangleMesh& b) {
  Eigen::AlignedBox3d box;
  for (const TriangleMesh* mesh : {&a, &b})
    for (const Eigen::Vector3d& v : mesh->vertices_mm) box.extend(v);
  const double spacing_mm = box.diagonal().norm() / 200;
  Grid grid;
  grid.size = (box.sizes() / spacing_mm).array().ceil().cast<int>() + 2;
  grid.index_to_world = Eigen::Translation3d(box.min()) * Eigen::Scaling(spacing_mm);
  return grid;
}

LabelVolume on_grid(const Shape& shape, const Grid& grid) {
  if (shape.labels) return *shape.labels;
  LabelVolume labels(grid);
  voxelize(shape.mesh, 1, labels);
  return labels;
}

double diagonal_mm(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) box.extend(v);
  return box.diagonal().norm();
}

Overlap overlap_of(const Shape& a, const Shape& b) {
  const Grid grid = a.labels ? a.labels->grid : b.labels ? b.labels->grid : common_grid(a.mesh, b.mesh);
  if (a.labels && b.labels && !a.labels->grid.index_to_world.isApprox(b.labels->grid.index_to_world, 1e-4))
    throw InputError("measure", "the two label volumes lie on different grids",
                     "put one on the other's grid with --grid");
  return overlap(on_grid(a, grid), on_grid(b, grid));
}

/// A minus B, and that in per cent of B.
void tell_difference(const std::string& name, const std::string& unit, double a, double b, Session& session) {
  nlohmann::json& entry = session.result["comparison"];
  const double percent = 100 * (a - b) / b;
  entry[name + "_difference_" + unit] = a - b;
  entry[name + "_difference_percent"] = percent;
  session.text += fmt::format("  {:<11} {:+.3f} {} ({:+.2f} %)\n", name, a - b, unit, percent);
}

void compare(const Shape& a, const Shape& b, const SurfaceDistanceOptions& options, Session& session) {
  const Overlap shared = overlap_of(a, b);
  const SurfaceDistance distance = surface_distance(a.mesh, b.mesh, options);
  const double diagonal = diagonal_mm(b.mesh);
  session.result["comparison"] = {{"dice", shared.dice},
                                  {"samples", options.samples},
                                  {"mean_distance_mm", distance.mean_mm},
                                  {"percentile95_distance_mm", distance.percentile95_mm},
                                  {"largest_distance_mm", distance.largest_mm},
                                  {"diagonal_mm", diagonal},
                                  {"mean_distance_of_diagonal", distance.mean_mm / diagonal},
                                  {"percentile95_distance_of_diagonal", distance.percentile95_mm / diagonal},
                                  {"largest_distance_of_diagonal", distance.largest_mm / diagonal}};
  session.text += "first minus second\n";
  tell_difference("volume", "mm3", a.measures.volume_mm3, b.measures.volume_mm3, session);
  if (!a.labels && !b.labels) tell_difference("area", "mm2", a.measures.area_mm2, b.measures.area_mm2, session);
  session.text += fmt::format(
      "  Dice        {:.4f}\n  distance    mean {:.3f} mm, 95 % {:.3f} mm, largest {:.3f} mm\n"
      "              {:.3f}, {:.3f}, {:.3f} % of the second's diagonal\n",
      shared.dice, distance.mean_mm, distance.percentile95_mm, distance.largest_mm, 100 * distance.mean_mm / diagonal,
      100 * distance.percentile95_mm / diagonal, 100 * distance.largest_mm / diagonal);
}

void run_measure(const MeasureCommand& command, Session& session) {
  const std::filesystem::path& path = command.input.paths.front();
  const Shape shape = read_shape(path, command, session);
  describe(path, shape, "shape", session);
  if (command.against.empty()) return;
  const Shape against = read_shape(command.against, command, session);
  describe(command.against, against, "against", session);
  compare(shape, against, command.distance, session);
}

void add_leave_out_options(CLI::App& command, MeasureCommand& options) {
  ReconstructOptions& r = options.leave_out.options;
  auto* leave_out = command
                        .add_option("--leave-out", options.leave_out.every,
                                    "Keep every K-th slice, reconstruct, and compare on the dropped ones")
                        ->allow_extra_args(false)
                        ->delimiter(',')
                        ->check(CLI::Range(2, 10'000))
                        ->type_name("K[,K...]")
                        ->excludes("--against");
  command.add_option("--plot", options.leave_out.plot, "Distance and Dice over K as a picture")
      ->check(written_path())
      ->needs(leave_out)
      ->type_name("FILE.svg");
  command.add_option("--kernel", options.kernel, "As in reconstruct")
      ->check(CLI::IsMember({"biharmonic", "thin_plate", "triharmonic"}))
      ->needs(leave_out);
  command.add_option("--smoothing", r.smoothing, "As in reconstruct")->check(CLI::NonNegativeNumber)->needs(leave_out);
  command.add_option("--max-constraints", r.max_constraints, "As in reconstruct")
      ->check(CLI::Range(12, 10'000'000))
      ->capture_default_str()
      ->needs(leave_out);
}

void run(const MeasureCommand& command, Session& session) {
  if (command.leave_out.every.empty()) return run_measure(command, session);
  LeaveOutCommand leave_out = command.leave_out;
  if (!command.kernel.empty()) leave_out.options.kernel = kernel_named(command.kernel);
  run_leave_out(leave_out, command.input, session);
}

}  // namespace

void add_measure(CLI::App& app, Session& session) {
  auto options = std::make_shared<MeasureCommand>();
  CLI::App* command = app.add_subcommand("measure", "Volume, area, topology of a surface or label volume; comparison");
  add_reading_options(*command, options->input);
  command->get_option("IN")->description(
      "Surface (.stl, .ply, .obj, .vtp), solid (.json), label or distance volume; with --leave-out as in segment");
  add_distance_option(*command, options->bodies);
  command->add_option("--against", options->against, "Compare with this surface or label volume")
      ->check(read_path())
      ->type_name("B");
  command->add_option("--samples", options->distance.samples, "Points drawn from each surface to measure distances")
      ->check(CLI::Range(100, 100'000'000))
      ->capture_default_str()
      ->needs("--against");
  add_leave_out_options(*command, *options);
  add_slice_choice(*command, options->input);
  add_segmentation_options(*command, options->input);
  command->callback([options, &session] {
    if (options->leave_out.every.empty() && options->input.paths.size() != 1)
      throw CLI::ValidationError("measure", "takes one surface or label volume; compare two with --against");
    session.run = [options, &session] { run(*options, session); };
  });
}

}  // namespace isostack::cli
