#include "recon/reconstruct.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/json_report.h"
#include "cli/outputs.h"
#include "io/volume_files.h"
#include "io/write_mesh.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/voxelize.h"

namespace isostack::cli {

namespace {

struct ReconstructCommand {
  InputOptions input;
  std::vector<std::filesystem::path> outputs;
  std::filesystem::path grid;
  std::string preset = "default";
  std::string kernel;
  std::string solver = "auto";
  double memory_gb = 8;
  ReconstructOptions options;
};

/// Options with the preset's and the command line's choices resolved.
ReconstructOptions resolved(const ReconstructCommand& command) {
  ReconstructOptions options = command.options;
  if (!command.kernel.empty()) options.kernel = kernel_named(command.kernel);
  options.solver = command.solver == "dense"  ? SolverChoice::dense
                   : command.solver == "fast" ? SolverChoice::fast
                                              : SolverChoice::automatic;
  options.memory_limit_bytes = static_cast<std::size_t>(command.memory_gb * 1e9);
  return options;
}

std::vector<Reconstruction> reconstruct_all(const ReconstructCommand& command, Session& session) {
  const ReconstructOptions options = resolved(command);
  std::vector<Reconstruction> surfaces;
  if (command.preset == "turk-obrien") {
    if (command.input.level.empty())
      throw InputError("--preset turk-obrien", "the paper's recipe works on grey images", "give --level V");
    const SliceStack images = chosen_slices(read_images(command.input, session), command.input);
    surfaces.push_back(reconstruct_turk_obrien(images, level_of(command.input), options, session.progress()));
    return surfaces;
  }
  for (const ContourStack& organ : organs_from(command.input, session)) {
    session.result["organs"].push_back(to_json(organ));
    surfaces.push_back(reconstruct(organ, options, session.progress()));
  }
  return surfaces;
}

void note_what_was_left_out(const Reconstruction& surface, Session& session) {
  const ReconstructReport& report = surface.report;
  if (report.boundary_constraints < report.contour_points)
    session.note(fmt::format(
        "{}: {} of {} contour points became constraints ({:.0f} %); --max-constraints keeps more", surface.surface.name,
        report.boundary_constraints, report.contour_points,
        100.0 * static_cast<double>(report.boundary_constraints) / static_cast<double>(report.contour_points)));
  if (report.open_end)
    session.note(surface.surface.name +
                 ": the organ goes on beyond the outermost slices; the surface ends flat, half a gap outside");
  if (report.contour_points_without_surface > 0)
    session.note(fmt::format("{}: {} contour points have no surface near them; a finer --resolution may show it",
                             surface.surface.name, report.contour_points_without_surface));
}

void describe(const Reconstruction& surface, Session& session) {
  const MeshMeasures measures = measure(surface.surface);
  nlohmann::json entry = to_json(surface.report);
  entry["name"] = surface.surface.name;
  entry["surface"] = to_json(measures);
  session.result["surfaces"].push_back(entry);
  session.text +=
      fmt::format("{}: {} constraints, solved in {:.1f} s, surface in {:.1f} s\n", surface.surface.name,
                  surface.report.constraints, surface.report.solve_seconds, surface.report.surface_seconds) +
      to_text(measures);
}

void write_surfaces(const std::vector<Reconstruction>& surfaces, const std::filesystem::path& output,
                    Session& session) {
  for (const Reconstruction& surface : surfaces) {
    const std::filesystem::path path = surfaces.size() == 1 ? output : with_suffix(output, surface.surface.name);
    write_mesh(surface.surface, path);
    session.result["outputs"].push_back(path.string());
    session.text += "wrote " + path.string() + "\n";
  }
}

void write_label_grid(const std::vector<Reconstruction>& surfaces, const ReconstructCommand& command,
                      const std::filesystem::path& output, Session& session) {
  const std::filesystem::path reference = command.grid.empty() ? command.input.paths.front() : command.grid;
  LabelVolume labels(read_grid(reference, command.input.read_options()));
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    voxelize(surfaces[i].surface, static_cast<std::uint16_t>(i + 1), labels);
  write_labels(labels, output);
  session.result["outputs"].push_back(output.string());
  session.text += "wrote " + output.string() + "\n";
}

void run_reconstruct(const ReconstructCommand& command, Session& session) {
  for (const std::filesystem::path& output : command.outputs) require_writable(output, OutputPurpose::kSurfaceOrLabels);
  const std::vector<Reconstruction> surfaces = reconstruct_all(command, session);
  for (const Reconstruction& surface : surfaces) {
    note_what_was_left_out(surface, session);
    describe(surface, session);
  }
  for (const std::filesystem::path& output : command.outputs) {
    session.progress().report("write", 0);
    if (is_label_file(output))
      write_label_grid(surfaces, command, output, session);
    else
      write_surfaces(surfaces, output, session);
  }
}

void add_solver_options(CLI::App& command, ReconstructCommand& options) {
  ReconstructOptions& r = options.options;
  command.add_option("--preset", options.preset, "How constraints are made: default, or the 1999 paper's own recipe")
      ->check(CLI::IsMember({"default", "turk-obrien"}));
  command.add_option("--kernel", options.kernel, "biharmonic (r), thin_plate (r² log r) or triharmonic (r³, default)")
      ->check(CLI::IsMember({"biharmonic", "thin_plate", "triharmonic"}));
  command.add_option("--solver", options.solver, "How the system is solved")
      ->check(CLI::IsMember({"auto", "dense", "fast"}))
      ->capture_default_str();
  command.add_flag("--accept-residual", r.accept_residual, "Go on when the solve stalls above its tolerance");
  command.add_option("--smoothing", r.smoothing, "0 passes through the contours, more approximates them")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--max-constraints", r.max_constraints, "Thin the contours to this many constraints")
      ->check(CLI::Range(12, 10'000'000))
      ->capture_default_str();
  command.add_option("--resolution", r.resolution_mm, "Edge of the surface's cells in mm (default: the pixel size)")
      ->check(CLI::PositiveNumber);
  command.add_option("--memory", options.memory_gb, "Memory the solve may take, GB")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

}  // namespace

void add_reconstruct(CLI::App& app, Session& session) {
  auto options = std::make_shared<ReconstructCommand>();
  CLI::App* command = app.add_subcommand("reconstruct", "Slices or contours to one closed surface per organ");
  add_reading_options(*command, options->input);
  add_slice_choice(*command, options->input);
  add_segmentation_options(*command, options->input);
  add_solver_options(*command, *options);
  command
      ->add_option("-o,--output", options->outputs,
                   "Surface (.stl, .ply, .obj, .vtp, .gltf) or labels (.nii, .nii.gz); may be repeated")
      ->required()
      ->type_name("OUT");
  command->add_option("--grid", options->grid, "Volume whose grid label output uses (default: the input's)")
      ->type_name("REF");
  command->callback([options, &session] { session.run = [options, &session] { run_reconstruct(*options, session); }; });
}

}  // namespace isostack::cli
