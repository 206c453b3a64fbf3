#include "recon/reconstruct.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/alignment.h"
#include "cli/commands.h"
#include "cli/dry_run.h"
#include "cli/input_options.h"
#include "cli/json_report.h"
#include "cli/label_outputs.h"
#include "cli/outputs.h"
#include "cli/path_roles.h"
#include "cli/retriangulation.h"
#include "io/meshes/write_mesh.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/metrics/choose_kernel.h"
#include "recon/metrics/voxelize.h"
#include "recon/predicted_memory.h"
#include "recon/reconstruct_all.h"

namespace isostack::cli {

namespace {

struct ReconstructCommand {
  InputOptions input;
  AlignmentCommand alignment;
  std::vector<std::filesystem::path> outputs;
  std::filesystem::path grid;
  std::string preset = "default";
  std::string kernel;
  std::string solver = "auto";
  std::string caps = "round";
  std::string axes = "lps";
  bool interpolate = false;
  double tolerance_mm = -1;  ///< negative: not given
  double memory_gb = 8;
  bool dry_run = false;
  ReconstructOptions options;
};

/// Options with the preset's and the command line's choices resolved.
ReconstructOptions resolved(const ReconstructCommand& command) {
  ReconstructOptions options = command.options;
  if (!command.kernel.empty() && command.kernel != "auto") options.kernel = kernel_named(command.kernel);
  options.solver = command.solver == "dense"  ? SolverChoice::dense
                   : command.solver == "fast" ? SolverChoice::fast
                                              : SolverChoice::automatic;
  if (command.tolerance_mm >= 0) options.tolerance_mm = command.tolerance_mm;
  options.accept_lost_contours = options.accept_residual;
  if (command.interpolate) options = interpolating(options);
  options.caps = command.caps == "flat" ? Caps::flat : command.caps == "open" ? Caps::open : Caps::round;
  options.memory_limit_bytes = static_cast<std::size_t>(command.memory_gb * 1e9);
  return options;
}

/// The kernel and smoothing that predict left-out slices of the organ with the most contour points best.
void choose_kernel(const std::vector<ContourStack>& organs, ReconstructOptions& options, Session& session) {
  const auto& organ = *std::max_element(organs.begin(), organs.end(),
                                        [](const auto& a, const auto& b) { return point_count(a) < point_count(b); });
  const std::vector<KernelTrial> trials = try_kernels(organ, options, session.progress());
  options.kernel = trials.front().kernel;
  options.smoothing = trials.front().smoothing;
  session.text += "kernels, by how they predict every second slice\n";
  for (const KernelTrial& trial : trials) {
    session.result["kernels"].push_back({{"kernel", trial.kernel.name()},
                                         {"smoothing", trial.smoothing},
                                         {"mean_distance_mm", trial.agreement.mean_mm},
                                         {"dice", trial.agreement.dice}});
    session.text += fmt::format("  {:<12} smoothing {:<8.3g} mean {:.3f} mm, Dice {:.4f}\n", trial.kernel.name(),
                                trial.smoothing, trial.agreement.mean_mm, trial.agreement.dice);
  }
}

SliceStack paper_images(const ReconstructCommand& command, Session& session) {
  if (command.input.level.empty())
    throw InputError("--preset turk-obrien", "the paper's recipe works on grey images", "give --level V");
  return chosen_slices(read_images(command.input, session), command.input);
}

std::vector<ContourStack> input_organs(const ReconstructCommand& command, Session& session) {
  std::vector<ContourStack> organs = aligned(drawn_organs_from(command.input, session), command.alignment, session);
  for (const ContourStack& organ : organs) session.result["organs"].push_back(to_json(organ));
  return organs;
}

std::vector<Reconstruction> reconstruct_inputs(const ReconstructCommand& command, Session& session) {
  ReconstructOptions options = resolved(command);
  if (command.preset == "turk-obrien")
    return {
        reconstruct_turk_obrien(paper_images(command, session), level_of(command.input), options, session.progress())};
  const std::vector<ContourStack> organs = input_organs(command, session);
  if (command.kernel == "auto") choose_kernel(organs, options, session);
  return reconstruct_all(organs, options, session.progress());
}

/// What a run would take. With --kernel auto that of r³, which takes the most.
void predict(ReconstructCommand command, Session& session) {
  command.alignment.aligned.clear();
  const ReconstructOptions options = resolved(command);
  MemoryPrediction prediction;
  std::size_t peak = 0;
  if (command.preset == "turk-obrien") {
    const SliceStack images = paper_images(command, session);
    peak = peak_memory_bytes();
    prediction = predict_memory_turk_obrien(images, level_of(command.input), options, resident_memory_bytes());
  } else {
    const std::vector<ContourStack> organs = input_organs(command, session);
    peak = peak_memory_bytes();
    prediction = predict_memory(organs, options, resident_memory_bytes());
  }
  prediction.process_bytes = std::max(prediction.process_bytes, peak);
  describe(prediction, session);
}

void note_what_was_left_out(const Reconstruction& surface, double thin_mm, Session& session) {
  const ReconstructReport& report = surface.report;
  if (thin_mm > 0 && report.contour_residual.largest_mm > thin_mm)
    session.note(
        fmt::format("{}: contour points are up to {:.3g} mm from the surface, more than the {:g} mm of --thin; "
                    "--max-constraints allows more constraints",
                    surface.surface.name, report.contour_residual.largest_mm, thin_mm));
  if (thin_mm <= 0 && report.boundary_constraints < report.contour_points)
    session.note(fmt::format(
        "{}: {} of {} contour points became constraints ({:.0f} %); --max-constraints keeps more", surface.surface.name,
        report.boundary_constraints, report.contour_points,
        100.0 * static_cast<double>(report.boundary_constraints) / static_cast<double>(report.contour_points)));
  if (report.open_end)
    session.note(surface.surface.name +
                 ": the organ goes on beyond the outermost slices; the surface ends flat, half a gap outside");
  if (report.sections.missed > 0)
    session.note(
        fmt::format("{}: {} contours have no section of the surface near them; a finer --resolution may show them",
                    surface.surface.name, report.sections.missed));
  if (report.contour_points_without_surface > 0)
    session.note(fmt::format("{}: {} contour points have no surface near them; a finer --resolution may show it",
                             surface.surface.name, report.contour_points_without_surface));
}

/// Smaller contradictions between crossing slices are not worth a line.
constexpr double least_contradiction_mm = 0.5;

void describe(const Reconstruction& surface, Session& session) {
  const MeshMeasures measures = measure(surface.surface);
  nlohmann::json entry = to_json(surface.report);
  entry["name"] = surface.surface.name;
  entry["surface"] = to_json(measures);
  session.result["surfaces"].push_back(entry);
  session.text +=
      fmt::format("{}: {} constraints, solved in {:.1f} s, surface in {:.1f} s\n", surface.surface.name,
                  surface.report.constraints, surface.report.solve_seconds, surface.report.surface_seconds) +
      fmt::format("  residual    {:.3f} mm mean, {:.3f} mm largest, of all contour points\n",
                  surface.report.contour_residual.mean_mm, surface.report.contour_residual.largest_mm) +
      fmt::format("  sections    {:.3f} mm mean, {:.3f} mm largest from the contours of {} slices; Dice {:.4f}\n",
                  surface.report.sections.mean_mm, surface.report.sections.largest_mm, surface.report.sections.slices,
                  surface.report.sections.dice) +
      to_text(measures) + to_text(surface.report.retriangulation) +
      to_text(surface.report.contradictions, least_contradiction_mm);
}

void write_surfaces(const std::vector<Reconstruction>& surfaces, const ReconstructCommand& command,
                    const std::filesystem::path& output, Session& session) {
  const WriteOptions options{.axes = command.axes == "ras" ? MeshAxes::ras : MeshAxes::lps};
  for (const Reconstruction& surface : surfaces) {
    const std::filesystem::path path = surfaces.size() == 1 ? output : with_suffix(output, surface.surface.name);
    write_mesh(surface.surface, path, options);
    session.wrote(path);
  }
}

void write_label_grid(const std::vector<Reconstruction>& surfaces, const ReconstructCommand& command,
                      const std::filesystem::path& output, Session& session) {
  const std::filesystem::path reference = command.grid.empty() ? command.input.paths.front() : command.grid;
  LabelVolume mask(read_grid(reference, command.input.read_options()));
  LabelMap labels{.layers = {mask}, .segments = {}};
  for (const Reconstruction& surface : surfaces) {
    std::fill(mask.voxels.begin(), mask.voxels.end(), std::uint16_t{0});
    voxelize(surface.surface, 1, mask);
    const auto value = static_cast<std::uint16_t>(labels.segments.size() + 1);
    add_segment(labels, mask, {.name = surface.surface.name, .value = value, .color = surface.surface.color});
  }
  write_organ_labels(labels, output, {}, session);
  session.wrote(output);
}

void run_reconstruct(const ReconstructCommand& command, Session& session) {
  if (command.dry_run) return predict(command, session);
  for (const std::filesystem::path& output : command.outputs) require_writable(output, OutputPurpose::kSurfaceOrLabels);
  const std::vector<Reconstruction> surfaces = reconstruct_inputs(command, session);
  for (const Reconstruction& surface : surfaces) {
    note_what_was_left_out(surface, command.options.thin_mm, session);
    describe(surface, session);
  }
  for (const std::filesystem::path& output : command.outputs) {
    session.progress().report("write", 0);
    if (is_label_file(output))
      write_label_grid(surfaces, command, output, session);
    else
      write_surfaces(surfaces, command, output, session);
  }
}

void add_solver_options(CLI::App& command, ReconstructCommand& options) {
  ReconstructOptions& r = options.options;
  command.add_option("--preset", options.preset, "How constraints are made: default, or the 1999 paper's own recipe")
      ->check(CLI::IsMember({"default", "turk-obrien"}));
  command
      .add_option("--kernel", options.kernel,
                  "biharmonic (r), thin_plate (r² log r), triharmonic (r³, default), or auto: whichever predicts "
                  "left-out slices best")
      ->check(CLI::IsMember({"biharmonic", "thin_plate", "triharmonic", "auto"}));
  command.add_option("--solver", options.solver, "How the system is solved")
      ->check(CLI::IsMember({"auto", "dense", "fast"}))
      ->capture_default_str();
  command.add_flag("--accept-residual", r.accept_residual,
                   "Go on when the solve stalls above its tolerance or the surface misses a contour");
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

void add_surface_options(CLI::App& command, ReconstructCommand& options) {
  command
      .add_option("--caps", options.caps,
                  "Ends beyond parallel slices: round (default), flat half a gap outside, or open")
      ->check(CLI::IsMember({"round", "flat", "open"}));
  CLI::Option* interpolate =
      command.add_flag("--interpolate", options.interpolate, "Pass through every constraint, also contradicting ones");
  command
      .add_option("--tolerance", options.tolerance_mm,
                  "The smoothest surface within this distance of all contour points, mm")
      ->check(CLI::NonNegativeNumber)
      ->excludes(interpolate)
      ->excludes("--smoothing");
  interpolate->excludes("--smoothing");
  command
      .add_option("--thin", options.options.thin_mm,
                  "As few constraints as bring all contour points within this distance of the surface, mm")
      ->check(CLI::PositiveNumber);
  command.add_option("--axes", options.axes, "World axes of the surface: lps (default) or ras; glTF has its own")
      ->check(CLI::IsMember({"lps", "ras"}));
  command.add_flag("--allow-overlap", options.options.allow_overlap,
                   "Leave each organ's surface as it is by itself, even where two overlap");
}

void require_options_that_agree(const ReconstructCommand& command) {
  if (command.preset == "turk-obrien" && (command.tolerance_mm >= 0 || command.options.thin_mm > 0))
    throw CLI::ValidationError("--preset turk-obrien",
                               "works on pixels, not contours; leave out --tolerance and --thin");
  if (command.caps == "open" && std::any_of(command.outputs.begin(), command.outputs.end(), is_label_file))
    throw CLI::ValidationError("--caps open", "labels need a closed surface; choose round or flat ends");
}

}  // namespace

void add_reconstruct(CLI::App& app, Session& session) {
  auto options = std::make_shared<ReconstructCommand>();
  CLI::App* command = app.add_subcommand("reconstruct", "Slices or contours to one closed surface per organ");
  add_reading_options(*command, options->input);
  add_slice_choice(*command, options->input);
  add_segmentation_options(*command, options->input);
  add_solver_options(*command, *options);
  add_alignment_options(*command, options->alignment);
  add_surface_options(*command, *options);
  add_retriangulation_options(*command, options->options.retriangulation);
  command
      ->add_option(
          "-o,--output", options->outputs,
          "Surface (.stl, .ply, .obj, .vtp, .gltf, .glb) or labels (.nii, .nii.gz, .nrrd, .mha); may be repeated")
      ->check(written_path())
      ->allow_extra_args(false)
      ->type_name("OUT");
  command->add_flag("--dry-run", options->dry_run,
                    "Only tell what a run would take: constraints, solver, memory of the whole program");
  command->add_option("--grid", options->grid, "Volume whose grid label output uses (default: the input's)")
      ->check(read_path())
      ->type_name("REF");
  command->callback([options, &session] {
    require_options_that_agree(*options);
    if (!options->dry_run && options->outputs.empty()) throw CLI::RequiredError("--output");
    if (options->dry_run && !session.record.empty())
      throw CLI::ValidationError("--dry-run", "writes nothing that could be recorded; leave out --record");
    session.run = [options, &session] { run_reconstruct(*options, session); };
  });
}

}  // namespace isostack::cli
