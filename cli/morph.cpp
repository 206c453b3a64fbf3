#include "recon/morphing/morph.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/landmarks.h"
#include "cli/morph_blend.h"
#include "cli/morph_frames.h"
#include "cli/morph_level_set.h"
#include "cli/morph_outputs.h"
#include "cli/morph_places.h"
#include "cli/morph_quality.h"
#include "cli/morph_shapes.h"
#include "cli/morph_subdivision.h"
#include "cli/path_roles.h"
#include "cli/recipe.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/morphing/signed_distance_morph.h"
#include "recon/morphing/variational_morph.h"

namespace isostack::cli {

namespace {

struct MorphCommand {
  InputOptions input;
  BodyOptions bodies;
  std::string method = "variational";
  std::string preset = "default";
  std::string kernel = "triharmonic";
  std::string solver = "auto";
  std::string between = "linear";
  double spacing_mm = 0;  ///< 0: not given
  double memory_gb = 8;
  VariationalMorphOptions variational;
  LevelSetMorphChoice level_set;
  BlendMorphChoice blend;
  SubdivisionMorphChoice subdivision;
  std::filesystem::path landmarks, plot;  ///< empty: none
  PlaceOptions places;
  MorphOutputs outputs;
  std::string recipe;
  std::filesystem::path save_recipe;
};

VariationalMorphOptions variational_options(const MorphCommand& command) {
  VariationalMorphOptions options = command.variational;
  if (command.preset == "turk-obrien") options.recipe = MorphRecipe::turk_obrien;
  options.kernel = kernel_named(command.kernel);
  options.layout = command.places.layout();
  if (command.spacing_mm > 0) options.spacing_mm = command.spacing_mm;
  options.solver = command.solver == "dense"  ? SolverChoice::dense
                   : command.solver == "fast" ? SolverChoice::fast
                                              : SolverChoice::automatic;
  options.memory_limit_bytes = static_cast<std::size_t>(command.memory_gb * 1e9);
  return options;
}

SignedDistanceMorphOptions distance_options(const MorphCommand& command) {
  return {.layout = command.places.layout(),
          .between = command.between == "cubic" ? AlongNormal::cubic : AlongNormal::linear,
          .resolution_mm = command.variational.resolution_mm,
          .memory_limit_bytes = static_cast<std::size_t>(command.memory_gb * 1e9)};
}

LevelSetMorphOptions level_set_base(const MorphCommand& command) {
  LevelSetMorphOptions options;
  if (!command.landmarks.empty()) options.landmarks = read_landmarks(command.landmarks);
  options.resolution_mm = command.variational.resolution_mm;
  options.memory_limit_bytes = static_cast<std::size_t>(command.memory_gb * 1e9);
  return options;
}

Morph morph_by_subdivision(const std::vector<KeyShape>& shapes, const MorphCommand& command, Session& session) {
  SubdivisionMorphOptions options =
      subdivision_options(command.subdivision, shapes, command.input, command.bodies, session);
  if (command.spacing_mm > 0) options.spacing_mm = command.spacing_mm;
  return subdivision_morph(shapes, options, session.progress());
}

Morph make_morph(const std::vector<KeyShape>& shapes, const MorphCommand& command, Session& session) {
  if (command.method == "level-set")
    return morph_by_level_sets(shapes, command.level_set, level_set_base(command), session);
  if (command.method == "subdivision") return morph_by_subdivision(shapes, command, session);
  const auto by_method = [&](const std::vector<KeyShape>& keys) {
    if (command.method == "blend")
      return blend_morph(keys, blend_options(command.blend, command.variational.resolution_mm), session.progress());
    return command.method == "variational" ? variational_morph(keys, variational_options(command), session.progress())
                                           : signed_distance_morph(keys, distance_options(command), session.progress());
  };
  if (command.landmarks.empty()) return by_method(shapes);
  return warped_morph(shapes, read_landmarks(command.landmarks), by_method);
}

void fill(const Morph& morph, std::vector<MorphFrame>& frames, Session& session) {
  std::vector<Eigen::VectorXd> weights;
  for (const MorphFrame& frame : frames) weights.push_back(frame.weights);
  std::vector<Shape> shapes = morph.frames(weights, session.progress());
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].shape = std::move(shapes[i]);
}

void describe(const std::vector<KeyShape>& shapes, const Morph& morph, double frame_seconds, Session& session) {
  for (const KeyShape& shape : shapes)
    session.result["shapes"].push_back({{"name", shape.name}, {"dimension", dimension_of(shape.shape)}});
  const MorphReport& report = morph.report();
  session.result.update(
      {{"method", report.method},
       {"spacing_mm", report.spacing_mm},
       {"constraints", report.constraints},
       {"resolution_mm", report.resolution_mm},
       {"solver", report.solve.solver},
       {"iterations", report.solve.iterations},
       {"sweeps", report.solve.sweeps},
       {"tolerance_mm", report.solve.tolerance},
       {"largest_residual_mm", report.solve.largest_residual},
       {"converged", report.solve.converged},
       {"seconds",
        {{"constraints", report.constraint_seconds}, {"solve", report.solve_seconds}, {"frames", frame_seconds}}},
       {"peak_bytes", peak_memory_bytes()}});
  if (!report.solve.converged) session.note("the solve stopped above its tolerance: " + report.solve.remark);
  if (report.constraints > 0)
    session.text +=
        fmt::format("{} constraints, {:.4g} mm between key shapes, solved in {:.1f} s ({}), frames in {:.1f} s\n",
                    report.constraints, report.spacing_mm, report.solve_seconds, report.solve.solver, frame_seconds);
  else
    session.text += fmt::format("{}: frames in {:.1f} s\n", report.method, frame_seconds);
}

void run_morph(const MorphCommand& command, Session& session) {
  require_writable(command.outputs);
  require_plot_name(command.plot);
  std::vector<KeyShape> shapes = read_key_shapes(command.input, command.bodies, session);
  place_key_shapes(command.places, shapes);
  require_fitting(command.outputs, dimension_of(shapes.front().shape));
  std::vector<MorphFrame> frames =
      places_of_frames(key_places(shapes, command.places.layout()), command.places);  // refused before the solve
  const Morph morph = make_morph(shapes, command, session);
  const Stopwatch stopwatch;
  fill(morph, frames, session);
  describe(shapes, morph, stopwatch.seconds(), session);
  const MorphProducts products = products_for(frames, morph, command.outputs, session.progress());
  report_quality(frames, command.plot, session);
  if (command.method == "blend") report_stray(frames, shapes, session);
  if (command.method == "subdivision") report_levels(morph.report(), session);
  write_outputs(frames, products, command.outputs, session);
}

void add_method_options(CLI::App& command, MorphCommand& options) {
  VariationalMorphOptions& v = options.variational;
  command
      .add_option("--method", options.method,
                  "variational (default), level-set, blend, subdivision, or signed-distance, the baseline")
      ->check(CLI::IsMember({"variational", "level-set", "blend", "subdivision", "signed-distance"}));
  command
      .add_option("--spacing", options.spacing_mm,
                  "Variational, subdivision: distance of neighbouring shapes in the extra dimension, mm: small is "
                  "local, large global "
                  "(default: half the shapes' size, of bodies a quarter)")
      ->check(CLI::PositiveNumber)
      ->type_name("MM");
  command.add_option("--preset", options.preset, "How constraints are made: default, or the 1999 paper's own recipe")
      ->check(CLI::IsMember({"default", "turk-obrien"}));
  command.add_option("--kernel", options.kernel, "biharmonic (r), thin_plate (r² log r) or triharmonic (r³, default)")
      ->check(CLI::IsMember({"biharmonic", "thin_plate", "triharmonic"}));
  command.add_option("--max-constraints", v.max_constraints, "Of all shapes together, at most")
      ->check(CLI::Range(12, 10'000'000))
      ->capture_default_str();
  command.add_option("--smoothing", v.smoothing, "0 passes through the shapes, more approximates them")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--solver", options.solver, "How the system is solved")
      ->check(CLI::IsMember({"auto", "dense", "fast"}));
  command.add_option("--between", options.between, "Signed-distance: linear (default), or cubic through all shapes")
      ->check(CLI::IsMember({"linear", "cubic"}));
  command.add_option("--landmarks", options.landmarks, "Points of two shapes that belong together (JSON)")
      ->check(read_path())
      ->type_name("FILE");
  command
      .add_option("--resolution", v.resolution_mm,
                  "Pixels or cells of the frames, mm (default: a pixel, or a hundredth of the shapes' size)")
      ->check(CLI::PositiveNumber)
      ->type_name("MM");
  command.add_option("--memory", options.memory_gb, "Memory the solve may take, GB")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void add_output_options(CLI::App& command, MorphCommand& options) {
  command
      .add_option(
          "-o,--output", options.outputs.paths,
          "Folder of frames, .gif, .png (contact sheet), .json or .vtp (contours), or a mesh (.stl, .ply, .obj, "
          ".gltf: the space-time surface of figures, one file per body); may be repeated")
      ->check(written_path())
      ->required()
      ->allow_extra_args(false)
      ->type_name("OUT");
  command.add_option("--format", options.outputs.format, "Of frames in a folder (default: png, of bodies stl)")
      ->check(CLI::IsMember({"png", "json", "vtp", "stl", "ply", "obj", "glb"}));
  command.add_option("--size", options.outputs.pictures.size_pixels, "Longer side of a frame's picture, pixels")
      ->check(CLI::Range(64, 4000))
      ->capture_default_str();
  command.add_option("--fps", options.outputs.frames_per_second, "Frames per second of a .gif")
      ->check(CLI::Range(0.1, 50.0))
      ->capture_default_str();
  command
      .add_option_function<std::vector<double>>(
          "--view-from",
          [&options](const std::vector<double>& v) {
            options.outputs.pictures.view_from = {v[0], v[1], v[2]};
          },
          "Pictures of bodies: direction from them to the camera, LPS")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,Z");
  command.add_option("--plot", options.plot, "Parts, holes, size and curvature over t as a picture")
      ->check(written_path())
      ->type_name("FILE.svg");
  command.add_option("--recipe", options.recipe, "Options from a file, or turk-obrien: the paper's own")
      ->type_name("turk-obrien|FILE");
  command.add_option("--save-recipe", options.save_recipe, "Write the options for `run` and --recipe")
      ->type_name("FILE");
}

void require_options_that_agree(const MorphCommand& command) {
  if (command.input.paths.size() < 2) throw CLI::ValidationError("morph", "takes two shapes or more");
  if (command.method != "signed-distance" && command.between == "cubic")
    throw CLI::ValidationError("--between", "belongs to --method signed-distance");
  if (command.method != "variational" && command.preset != "default")
    throw CLI::ValidationError("--method " + command.method, "has no presets");
  if (command.method != "variational" && command.method != "subdivision" && command.spacing_mm > 0)
    throw CLI::ValidationError("--method " + command.method, "has no spacing");
  if (command.method == "level-set" && command.places.layout() != KeyLayout::line)
    throw CLI::ValidationError("--path", "mixes shapes, which a level-set morph does not");
  if (command.method == "blend" && command.places.layout() != KeyLayout::line)
    throw CLI::ValidationError("--path", "mixes shapes, which a blend does not");
  if (command.method == "subdivision" && command.places.layout() != KeyLayout::line)
    throw CLI::ValidationError("--path", "mixes shapes, which subdivision does not");
  if (command.method == "subdivision" && !command.landmarks.empty())
    throw CLI::ValidationError("--landmarks", "give --features instead, which need no warp");
  if (command.method != "subdivision" && !command.subdivision.is_default())
    throw CLI::ValidationError("--features, --key-shape, --sharp-angle, --levels, --gamma, --details, --sweep",
                               "belong to --method subdivision");
  if (command.method != "blend" && !command.blend.is_default())
    throw CLI::ValidationError("--ends, --slab, --gap, --blend, --length, --pull", "belong to --method blend");
  if (command.method != "level-set" && !command.level_set.is_default())
    throw CLI::ValidationError("--approach, --pace, --transform, --missing-parts", "belong to --method level-set");
  if (!command.landmarks.empty() && command.input.paths.size() != 2)
    throw CLI::ValidationError("--landmarks", "belong to two shapes");
}

void take_recipe(const MorphCommand& options, CLI::App& command) {
  apply_recipe(read_recipe(options.recipe), options.recipe, command);
  try {
    require_options_that_agree(options);
  } catch (const CLI::Error& error) {
    throw InputError("recipe " + options.recipe,
                     std::string("it does not go with the other options (") + error.what() + ")",
                     "leave out one of them");
  }
}

}  // namespace

void add_morph(CLI::App& app, Session& session) {
  auto options = std::make_shared<MorphCommand>();
  CLI::App* command = app.add_subcommand("morph", "Shapes between given shapes: figures or bodies");
  command
      ->add_option("IN", options->input.paths,
                   "Two or more shapes: contours, meshes, solids, pictures, grey, label or distance volumes")
      ->check(read_path())
      ->required();
  add_method_options(*command, *options);
  add_level_set_options(*command, options->level_set);
  add_blend_options(*command, options->blend);
  add_subdivision_options(*command, options->subdivision);
  add_place_options(*command, options->places);
  add_output_options(*command, *options);
  add_source_options(*command, options->input);
  add_distance_option(*command, options->bodies);
  add_mend_option(*command, options->bodies);
  command
      ->add_option("--pixel", options->input.spacing_mm, "Column, row and slice distance of PNG and TIFF in mm (1,1,1)")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::PositiveNumber)
      ->type_name("X,Y,Z");
  add_slice_choice(*command, options->input);
  add_segmentation_options(*command, options->input);
  command->callback([options, command, &session] {
    require_options_that_agree(*options);
    session.run = [options, command, &session] {
      if (!options->recipe.empty()) take_recipe(*options, *command);
      run_morph(*options, session);
      if (!options->save_recipe.empty()) write_recipe(*command, options->save_recipe);
    };
  });
}

}  // namespace isostack::cli
