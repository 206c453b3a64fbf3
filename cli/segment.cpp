#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"
#include "cli/input_options.h"
#include "cli/json_report.h"
#include "cli/outputs.h"
#include "io/contour_files.h"
#include "io/volume_files.h"
#include "recon/geometry/errors.h"
#include "segmentation/rasterize.h"

namespace isostack::cli {

namespace {

struct SegmentCommand {
  InputOptions input;
  std::filesystem::path output;
};

void run_segment(const SegmentCommand& command, Session& session) {
  require_writable(command.output, OutputPurpose::kContoursOrLabels);
  const std::vector<ContourStack> organs = organs_from(command.input, session);
  if (is_label_file(command.output)) {
    LabelMap labels{.layers = {LabelVolume(read_grid(command.input.paths.front(), command.input.read_options()))},
                    .segments = {}};
    for (const ContourStack& organ : organs) {
      const auto value = static_cast<std::uint16_t>(labels.segments.size() + 1);
      rasterize(organ, value, labels.layers.front());
      labels.segments.push_back({.name = organ.name, .value = value, .layer = 0, .color = organ.color});
    }
    write_labels(labels, command.output);
  } else {
    write_contours(organs, command.output);
  }
  for (const ContourStack& organ : organs) {
    const nlohmann::json summary = to_json(organ);
    session.text += fmt::format("{}: {} contours with {} points on {} of {} slices\n", organ.name,
                                summary["contours"].get<int>(), summary["points"].get<int>(),
                                summary["slices_with_contour"].get<int>(), summary["slices"].get<int>());
    session.result["organs"].push_back(summary);
  }
  session.result["output"] = command.output.string();
  session.text += "wrote " + command.output.string() + "\n";
}

}  // namespace

void add_segment(CLI::App& app, Session& session) {
  auto options = std::make_shared<SegmentCommand>();
  CLI::App* command = app.add_subcommand("segment", "Slices to contours or labels");
  add_reading_options(*command, options->input);
  add_slice_choice(*command, options->input);
  add_segmentation_options(*command, options->input);
  command->add_option("-o,--output", options->output, "Contours (.vtp, .json) or labels (.nii, .nii.gz)")
      ->required()
      ->type_name("OUT");
  command->callback([options, &session] { session.run = [options, &session] { run_segment(*options, session); }; });
}

}  // namespace isostack::cli
