#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/json_report.h"
#include "cli/label_outputs.h"
#include "cli/labels_on_series.h"
#include "cli/like_options.h"
#include "cli/outputs.h"
#include "cli/path_roles.h"
#include "cli/recipe.h"
#include "io/contours/contour_files.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"
#include "segmentation/rasterize.h"

namespace isostack::cli {

namespace {

struct SegmentCommand {
  InputOptions input;
  std::filesystem::path output;
  std::string as;
  LikeOptions like;
  std::string recipe;                 ///< name or file; empty: none
  std::filesystem::path save_recipe;  ///< empty: none
};

/// On the grid of options.like if there is one, else on that of the input.
LabelMap labels_of(const std::vector<ContourStack>& organs, const InputOptions& input, const WriteOptions& options) {
  ReadOptions reading = input.read_options();
  if (options.like) reading.series = options.like_series;
  LabelVolume mask(read_grid(options.like.value_or(input.paths.front()), reading));
  LabelMap labels{.layers = {mask}, .segments = {}};
  for (const ContourStack& organ : organs) {
    std::fill(mask.voxels.begin(), mask.voxels.end(), std::uint16_t{0});
    rasterize(organ, 1, mask);
    const auto value = static_cast<std::uint16_t>(labels.segments.size() + 1);
    add_segment(labels, mask, {.name = organ.name, .value = value, .layer = 0, .color = organ.color});
  }
  return labels;
}

void run_segment(const SegmentCommand& command, Session& session) {
  const DicomOutput dicom = command.as == "seg" ? DicomOutput::kSegmentation : DicomOutput::kStructureSet;
  require_writable(command.output, OutputPurpose::kContoursOrLabels, dicom);
  const bool cuts_labels = !writes_labels(command.output, dicom) && are_labels_for_series(command.input, command.like);
  const std::vector<ContourStack> organs =
      cuts_labels ? labels_on_series(command.input, command.like, session) : organs_from(command.input, session);
  if (writes_labels(command.output, dicom)) {
    const WriteOptions options = write_options_for(command.like, command.input);
    write_organ_labels(labels_of(organs, command.input, options), command.output, options, session);
  } else {
    note_dropped_organs(organs, command.output, session);
    write_contours(organs, command.output, write_options_for(command.like, command.input));
  }
  for (const ContourStack& organ : organs) {
    const nlohmann::json summary = to_json(organ);
    session.text += fmt::format("{}: {} contours with {} points on {} of {} slices\n", organ.name,
                                summary["contours"].get<int>(), summary["points"].get<int>(),
                                summary["slices_with_contour"].get<int>(), summary["slices"].get<int>());
    session.result["organs"].push_back(summary);
  }
  session.result["output"] = command.output.string();
  session.wrote(command.output);
}

}  // namespace

void add_segment(CLI::App& app, Session& session) {
  auto options = std::make_shared<SegmentCommand>();
  CLI::App* command = app.add_subcommand("segment", "Slices to contours or labels");
  add_reading_options(*command, options->input);
  add_slice_choice(*command, options->input);
  add_segmentation_options(*command, options->input);
  command
      ->add_option("-o,--output", options->output,
                   "Contours (.vtp, .json, RTSTRUCT .dcm) or labels (.nii, .nii.gz, .nrrd, .mha, SEG .dcm)")
      ->check(written_path())
      ->required()
      ->type_name("OUT");
  command->add_option("--as", options->as, "What a .dcm output is: rtstruct (contours, default) or seg (labels)")
      ->check(CLI::IsMember({"rtstruct", "seg"}));
  add_like_options(*command, options->like);
  command
      ->add_option("--distance", options->input.organ.distance_file,
                   "Also the signed distance in mm, positive inside, as a volume (.nii.gz, .nrrd, .mha)")
      ->check(written_path())
      ->type_name("FILE");
  command
      ->add_option("--recipe", options->recipe,
                   "Options from a file or of a preset: bone-ct, skin, soft-tissue-ct, blood-pool-mr")
      ->type_name("NAME|FILE");
  command->add_option("--save-recipe", options->save_recipe, "Write the options for `run` and --recipe")
      ->type_name("FILE");
  command->callback([options, command, &session] {
    session.run = [options, command, &session] {
      if (!options->recipe.empty()) apply_recipe(read_recipe(options->recipe), options->recipe, *command);
      run_segment(*options, session);
      if (!options->save_recipe.empty()) write_recipe(*command, options->save_recipe);
    };
  });
}

}  // namespace isostack::cli
