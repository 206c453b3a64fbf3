#include "cli/input_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "cli/label_inputs.h"
#include "cli/path_roles.h"
#include "cli/segment_images.h"
#include "io/contours/contour_files.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"
#include "segmentation/small_contours.h"

namespace isostack::cli {

ReadOptions InputOptions::read_options() const {
  ReadOptions options{.series = series, .spacing_mm = std::nullopt};
  if (phase > 0) options.phase = phase;
  options.unite_contours = unite_contours;
  if (!images.empty()) options.images = images;
  if (!spacing_mm.empty()) options.spacing_mm = Eigen::Vector3d(spacing_mm[0], spacing_mm[1], spacing_mm[2]);
  return options;
}

void add_reading_options(CLI::App& command, InputOptions& options) {
  command.add_option("IN", options.paths, "DICOM folder or file, NIfTI, NRRD, MetaImage, image folder, or contours")
      ->check(read_path())
      ->required();
  add_source_options(command, options);
  command.add_option("--spacing", options.spacing_mm, "Column, row and slice distance in mm of a PNG or TIFF stack")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::PositiveNumber)
      ->type_name("X,Y,Z");
}

void add_source_options(CLI::App& command, InputOptions& options) {
  command.add_option("--series", options.series, "Which DICOM series of a folder: its number in `info`, or its UID");
  command.add_option("--phase", options.phase, "Which of several DICOM pictures of the same places, from 1")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  command.add_option("--organ", options.organs, "Contour input: only the organ of this name (may be repeated)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command.add_flag("--union", options.unite_contours,
                   "RTSTRUCT: overlapping contours of one slice add up; otherwise an even number of them is a hole");
  command
      .add_option("--images", options.images,
                  "RTSTRUCT: the images it was drawn on; otherwise looked for in its folder")
      ->check(read_path());
}

void add_slice_choice(CLI::App& command, InputOptions& options) {
  auto* every = command.add_option("--every", options.every, "Use every K-th slice only")->check(CLI::PositiveNumber);
  command.add_option("--slices", options.slices, "Use these slices only (numbers from 0)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes(every);
}

void add_segmentation_options(CLI::App& command, InputOptions& options) {
  SegmentationOptions& s = options.segmentation;
  auto* level = command.add_option("--level", options.level, "Grey input: the organ is at least this bright (CT: HU)")
                    ->check(CLI::Number)
                    ->type_name("V");
  command.add_option("--label", options.label, "Label input: the label of this number or name, or `all`")
      ->excludes(level)
      ->type_name("N|NAME|all");
  command.add_flag("--darker", options.darker, "The organ is darker than --level")->needs(level);
  command.add_option("--gaussian", s.gaussian_sigma_pixels, "Low-pass filter, standard deviation in pixels")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--curvature", s.curvature,
                  "Level set: weight of the curvature term in pixels (0: exact level curves)")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--steps", s.max_steps, "Level set: steps at most")->check(CLI::PositiveNumber);
  command.add_flag("--fill-holes", s.fill_holes, "Fill background enclosed by the organ within each slice");
  command.add_flag("--largest", s.largest, "Keep the largest connected part only");
  add_organ_options(command, options.organ);
}

namespace {

std::vector<ContourStack> read_contour_inputs(const InputOptions& options, Session& session) {
  std::vector<ContourStack> organs;
  for (const std::filesystem::path& path : options.paths) {
    ContourFile file = read_contour_file(path, options.read_options());
    for (const std::string& warning : file.warnings) session.note(warning);
    for (ContourStack& organ : file.organs) {
      const auto same = std::find_if(organs.begin(), organs.end(), [&](const auto& o) { return o.name == organ.name; });
      if (same == organs.end())
        organs.push_back(std::move(organ));
      else
        same->slices.insert(same->slices.end(), organ.slices.begin(), organ.slices.end());
    }
  }
  return organs;
}

/// The organs that --organ names, in the order of the file; without it all.
std::vector<ContourStack> chosen_organs(std::vector<ContourStack> organs, const InputOptions& options) {
  if (options.organs.empty()) return organs;
  std::vector<std::string> names;
  for (const ContourStack& organ : organs) names.push_back(organ.name);
  for (const std::string& wanted : options.organs)
    if (std::find(names.begin(), names.end(), wanted) == names.end())
      throw InputError(options.paths.front().string(), "there is no organ '" + wanted + "' in it",
                       fmt::format("choose among {}", fmt::join(names, ", ")));
  std::vector<ContourStack> chosen;
  for (ContourStack& organ : organs) {
    const bool wanted = std::find(options.organs.begin(), options.organs.end(), organ.name) != options.organs.end();
    if (wanted) chosen.push_back(std::move(organ));
  }
  return chosen;
}

/// Positions (from 0) that --every and --slices keep of `count` slices.
std::vector<std::size_t> kept_positions(const InputOptions& options, std::size_t count, const std::string& name) {
  std::vector<std::size_t> kept;
  for (const int slice : options.slices) {
    if (slice < 0 || static_cast<std::size_t>(slice) >= count)
      throw InputError(name, fmt::format("there is no slice {} among its {}", slice, count),
                       "number the slices of --slices from 0");
    kept.push_back(static_cast<std::size_t>(slice));
  }
  if (!options.slices.empty()) return kept;
  for (std::size_t i = 0; i < count; i += static_cast<std::size_t>(options.every)) kept.push_back(i);
  return kept;
}

std::vector<int> labels_asked_for(const InputOptions& options, const SliceStack& stack) {
  if (options.label == "all") return labels_in(stack);
  int label = 0;
  const char* end = options.label.data() + options.label.size();
  if (std::from_chars(options.label.data(), end, label).ptr != end)
    throw InputError("--label", "'" + options.label + "' is not a label", "give a whole number or `all`");
  return {label};
}

}  // namespace

SliceStack read_images(const InputOptions& options, Session& session) {
  SliceStack scene;
  for (const std::filesystem::path& path : options.paths) {
    SliceStack stack = read_slices(path, options.read_options(), session.progress());
    for (const std::string& warning : stack.warnings) session.note(warning);
    if (scene.slices.empty()) scene.name = stack.name;
    std::move(stack.slices.begin(), stack.slices.end(), std::back_inserter(scene.slices));
  }
  return scene;
}

SliceStack chosen_slices(const SliceStack& stack, const InputOptions& options) {
  SliceStack chosen{.name = stack.name, .slices = {}, .warnings = stack.warnings};
  for (const std::size_t i : kept_positions(options, stack.slices.size(), stack.name))
    chosen.slices.push_back(stack.slices[i]);
  return chosen;
}

double level_of(const InputOptions& options) { return std::stod(options.level); }

std::vector<ContourStack> drawn_organs_from(const InputOptions& options, Session& session) {
  std::vector<ContourStack> organs = organs_from(options, session);
  if (organs.size() == 1) return organs;  // its emptiness is for the caller to refuse
  std::erase_if(organs, [&](const ContourStack& organ) {
    if (point_count(organ) > 0) return false;
    session.note(fmt::format("{}: it is drawn nowhere and left out", organ.name));
    return true;
  });
  return organs;
}

std::vector<ContourStack> organs_from(const InputOptions& options, Session& session) {
  for (const std::filesystem::path& path : options.paths) require_exists(path);  // before asking for a rule
  if (std::all_of(options.paths.begin(), options.paths.end(), is_contour_file)) {
    std::vector<ContourStack> organs = chosen_organs(read_contour_inputs(options, session), options);
    for (ContourStack& organ : organs) {
      std::vector<ContourSlice> kept;
      for (const std::size_t i : kept_positions(options, organ.slices.size(), organ.name))
        kept.push_back(organ.slices[i]);
      organ.slices = std::move(kept);
    }
    return organs;
  }
  const bool all_labels = std::all_of(options.paths.begin(), options.paths.end(), may_hold_labels);
  const bool all_named = std::all_of(options.paths.begin(), options.paths.end(), holds_named_organs);
  if (options.level.empty() && !options.organ.has_rule() && all_labels && (all_named || !options.label.empty()))
    return organs_in_labels(options, session);
  if (options.level.empty() && options.label.empty() && !options.organ.has_rule())
    throw InputError(
        options.paths.front().string(), "images need a rule that says where the organ is",
        "give --level V, --range LO,HI, --otsu or --seed X,Y,Z for grey images, or --label N for label images");
  const SliceStack stack = chosen_slices(read_images(options, session), options);
  if (options.label.empty()) return segment_images(stack, options, session);
  std::vector<ContourStack> organs;
  const LabelOptions labels{.fill_holes = options.segmentation.fill_holes, .largest = options.segmentation.largest};
  for (const int label : labels_asked_for(options, stack)) {
    organs.push_back(trace_label(stack, label, labels, session.progress()));
    organs.back().name = std::to_string(label);
    if (const std::string remark = remark_on_one_pixel_contours(organs.back()); !remark.empty()) session.note(remark);
  }
  return organs;
}

}  // namespace isostack::cli
