#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "cli/body_inputs.h"
#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/json_report.h"
#include "cli/leave_out.h"
#include "cli/path_roles.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "io/meshes/read_mesh.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/label_map.h"
#include "recon/metrics/compare.h"
#include "recon/metrics/surface_distance.h"

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

/// The voxels of the organs that --label asks for, all without it, as 1.
LabelVolume read_voxels_of(const std::filesystem::path& path, const std::string& label) {
  const LabelMap map = read_labels(path);
  LabelVolume voxels(map.layers.front().grid);
  for (const Segment& segment : chosen_segments(map, label.empty() ? "all" : label, path.string()))
    std::transform(map.layers[segment.layer].voxels.begin(), map.layers[segment.layer].voxels.end(),
                   voxels.voxels.begin(), voxels.voxels.begin(), [&](std::uint16_t value, std::uint16_t before) {
                     return static_cast<std::uint16_t>(value == segment.value ? 1 : before);
                   });
  return voxels;
}

/// A body (read_body), or a label volume: voxels of the chosen label, or all that are not 0.
MeasuredBody read_shape(const std::filesystem::path& path, const MeasureCommand& command, Session& session) {
  require_exists(path);
  std::optional<TriangleMesh> body = read_body(path, command.bodies, session);
  if (!body && find_format(path, &Format::read_mesh) != nullptr) body = read_mesh(path);  // throws: no mesh in it
  return body ? measured(std::move(*body)) : measured(read_voxels_of(path, command.input.label), path.string());
}

void describe(const std::filesystem::path& path, const MeasuredBody& shape, const char* key, Session& session) {
  session.text += path.string() + "\n" + to_text(shape.measures);
  session.result[key] = to_json(shape.measures);
  if (!shape.measures.watertight())
    session.note(path.string() + " is not closed: its volume and overlap say little, and it has no genus");
  if (!shape.labels) return;
  const auto count = std::count_if(shape.labels->voxels.begin(), shape.labels->voxels.end(), [](auto v) { return v; });
  session.result[key]["voxels"] = count;
  session.text += fmt::format("  voxels      {} (the area is that of their faces)\n", count);
}

/// A minus B, and that in per cent of B.
void tell_difference(const std::string& name, const std::string& unit, double difference, double b, Session& session) {
  nlohmann::json& entry = session.result["comparison"];
  const double percent = 100 * difference / b;
  entry[name + "_difference_" + unit] = difference;
  entry[name + "_difference_percent"] = percent;
  session.text += fmt::format("  {:<11} {:+.3f} {} ({:+.2f} %)\n", name, difference, unit, percent);
}

void tell_comparison(const MeasuredBody& a, const MeasuredBody& b, const SurfaceDistanceOptions& options,
                     Session& session) {
  const BodyComparison found = compare(a, b, options);
  const SurfaceDistance& distance = found.distance;
  const double diagonal = found.diagonal_mm;
  session.result["comparison"] = {{"dice", found.dice},
                                  {"samples", options.samples},
                                  {"mean_distance_mm", distance.mean_mm},
                                  {"percentile95_distance_mm", distance.percentile95_mm},
                                  {"largest_distance_mm", distance.largest_mm},
                                  {"diagonal_mm", diagonal},
                                  {"mean_distance_of_diagonal", distance.mean_mm / diagonal},
                                  {"percentile95_distance_of_diagonal", distance.percentile95_mm / diagonal},
                                  {"largest_distance_of_diagonal", distance.largest_mm / diagonal}};
  session.text += "first minus second\n";
  tell_difference("volume", "mm3", found.volume_difference_mm3, b.measures.volume_mm3, session);
  if (found.area_difference_mm2)
    tell_difference("area", "mm2", *found.area_difference_mm2, b.measures.area_mm2, session);
  session.text += fmt::format(
      "  Dice        {:.4f}\n  distance    mean {:.3f} mm, 95 % {:.3f} mm, largest {:.3f} mm\n"
      "              {:.3f}, {:.3f}, {:.3f} % of the second's diagonal\n",
      found.dice, distance.mean_mm, distance.percentile95_mm, distance.largest_mm, 100 * distance.mean_mm / diagonal,
      100 * distance.percentile95_mm / diagonal, 100 * distance.largest_mm / diagonal);
}

void run_measure(const MeasureCommand& command, Session& session) {
  const std::filesystem::path& path = command.input.paths.front();
  const MeasuredBody shape = read_shape(path, command, session);
  describe(path, shape, "shape", session);
  if (command.against.empty()) return;
  const MeasuredBody against = read_shape(command.against, command, session);
  describe(command.against, against, "against", session);
  tell_comparison(shape, against, command.distance, session);
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
