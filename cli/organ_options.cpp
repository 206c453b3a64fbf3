#include "cli/organ_options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <optional>

#include "cli/input_options.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"
#include "segmentation/organ_rules.h"

namespace isostack::cli {

namespace {

void add_rules(CLI::App& command, OrganInput& options) {
  CLI::Option* level = command.get_option("--level");
  CLI::Option* label = command.get_option("--label");
  CLI::Option* range = command.add_option("--range", options.range, "Grey input: the organ is between these values")
                           ->delimiter(',')
                           ->expected(2)
                           ->type_name("LO,HI")
                           ->excludes(level)
                           ->excludes(label);
  CLI::Option* otsu = command.add_flag("--otsu", options.otsu, "The organ is brighter than Otsu's level")
                          ->excludes(level)
                          ->excludes(label)
                          ->excludes(range);
  command.add_flag("--otsu-darker", options.otsu_darker, "The organ is darker than Otsu's level")
      ->excludes(level)
      ->excludes(label)
      ->excludes(range)
      ->excludes(otsu);
  command
      .add_option(
          "--seed", options.seeds,
          "A point of the organ, world LPS mm; may be repeated: one organ per name. The name - marks what is not "
          "wanted")
      ->type_name("X,Y,Z[,NAME]")
      ->allow_extra_args(false)
      ->excludes(label);
  command
      .add_option("--spread", options.spread,
                  "Seeds without another rule: grey values within this many standard deviations of theirs (2.5)")
      ->check(CLI::PositiveNumber);
}

void add_start(CLI::App& command, OrganInput& options) {
  command
      .add_option("--diffusion", options.diffusion,
                  "Edge-keeping filter: grey steps well above CONTRAST stay; number of steps (10)")
      ->delimiter(',')
      ->expected(1, 2)
      ->check(CLI::PositiveNumber)
      ->type_name("CONTRAST[,STEPS]");
  command.add_option("--start", options.start, "A further step of the start, in this order; may be repeated")
      ->type_name("STEP")
      ->allow_extra_args(false);
  command.add_option("--open", options.open_mm, "Opening: part what hangs together by less than twice this radius")
      ->check(CLI::PositiveNumber)
      ->type_name("MM");
  command.add_option("--close", options.close_mm, "Closing: fill gaps narrower than twice this radius")
      ->check(CLI::PositiveNumber)
      ->type_name("MM");
  command.add_flag("--hull", options.hull, "Every part becomes its convex hull, slice by slice");
  command
      .add_option("--propagate", options.propagate_mm,
                  "From the seed's slice to its neighbours, each at most this much beyond the one before")
      ->check(CLI::PositiveNumber)
      ->type_name("MM");
  command.add_flag("--volume", options.in_volume, "Motions and evolution in 3D; needs evenly spaced slices");
}

void add_terms(CLI::App& command, EvolutionOptions& options) {
  command.add_option("--range-weight", options.range_weight, "Level set: weight of the term that seeks the level")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--region", options.region, "Level set: weight of the region term (two means)")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--region-window", options.region_window_mm, "Its means are taken this near (0: everywhere)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("MM");
  command.add_option("--edge", options.edge, "Level set: weight of the edge term in pixels")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--edge-contrast", options.edge_contrast, "Slope of an edge in grey values per mm (0: estimated)")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--stay", options.stay_mm, "Level set: go no farther beyond the start than this (0: free)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("MM");
  command.add_option("--balloon", options.balloon, "Level set: speed outwards (negative: inwards); edges stop it");
}

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Seed parse_seed(const std::string& text) {
  Seed seed;
  std::string_view rest = text;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t comma = rest.find(',');
    const std::optional<double> value = number_in(rest.substr(0, comma));
    if (!value || (axis < 2 && comma == std::string_view::npos))
      throw InputError("--seed " + text, "it is not a place",
                       "give X,Y,Z in mm, and perhaps a name: 12.5,-40,310,liver");
    seed.position_mm[axis] = *value;
    rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
  }
  seed.name = rest;
  return seed;
}

/// "labels:FILE" or "labels:FILE,N".
StartStep read_labels_step(const std::string& text) {
  std::string file = text.substr(std::string_view("labels:").size());
  LabelStep step;
  if (const std::size_t comma = file.rfind(','); comma != std::string::npos)
    if (const auto label = number_in(std::string_view(file).substr(comma + 1))) {
      step.label = static_cast<int>(*label);
      file.resize(comma);
    }
  step.labels = std::make_shared<const Volume<float>>(read_volume(file));
  return step;
}

DiffusionOptions diffusion_from(const std::vector<double>& values) {
  DiffusionOptions diffusion{.contrast = values[0]};
  if (values.size() > 1) diffusion.steps = static_cast<int>(values[1]);
  return diffusion;
}

}  // namespace

void add_organ_options(CLI::App& command, OrganInput& options) {
  add_rules(command, options);
  add_start(command, options);
  add_terms(command, options.evolution);
}

OrganOptions organ_options(const InputOptions& options) {
  const OrganInput& organ = options.organ;
  OrganRules rules{.darker = options.darker,
                   .otsu = organ.otsu,
                   .otsu_darker = organ.otsu_darker,
                   .gaussian_sigma_pixels = options.segmentation.gaussian_sigma_pixels,
                   .open_mm = organ.open_mm,
                   .close_mm = organ.close_mm,
                   .hull = organ.hull,
                   .fill_holes = options.segmentation.fill_holes,
                   .largest = options.segmentation.largest,
                   .propagate_mm = organ.propagate_mm,
                   .in_volume = organ.in_volume,
                   .evolution = organ.evolution};
  if (!options.level.empty()) rules.level = level_of(options);
  if (!organ.range.empty()) {
    if (!(organ.range[0] < organ.range[1]))
      throw InputError("--range", "its lower value is not below the upper", "give LO,HI");
    rules.range = GreyRange{organ.range[0], organ.range[1]};
  }
  if (organ.spread > 0) rules.spread = organ.spread;
  if (!organ.diffusion.empty()) rules.diffusion = diffusion_from(organ.diffusion);
  for (const std::string& text : organ.start)
    rules.start.push_back(text.starts_with("labels:") ? read_labels_step(text) : parse_start_step(text));
  for (const std::string& text : organ.seeds) rules.seeds.push_back(parse_seed(text));
  rules.evolution.curvature = options.segmentation.curvature;
  rules.evolution.max_steps = options.segmentation.max_steps;
  return isostack::organ_options(rules);
}

}  // namespace isostack::cli
