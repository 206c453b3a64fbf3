#include "cli/organ_options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <limits>
#include <optional>

#include "cli/input_options.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

void add_rule_step(const InputOptions& options, std::vector<StartStep>& steps) {
  const OrganInput& organ = options.organ;
  if (!options.level.empty())
    steps.push_back(
        RangeStep{options.darker ? GreyRange{-infinity, level_of(options)} : GreyRange{level_of(options), infinity}});
  else if (!organ.range.empty() && !(organ.range[0] < organ.range[1]))
    throw InputError("--range", "its lower value is not below the upper", "give LO,HI");
  else if (!organ.range.empty())
    steps.push_back(RangeStep{{organ.range[0], organ.range[1]}});
  else if (organ.otsu || organ.otsu_darker)
    steps.push_back(OtsuStep{organ.otsu});
  else if (organ.spread > 0)
    steps.push_back(SeedRangeStep{organ.spread});
}

}  // namespace

void add_organ_options(CLI::App& command, OrganInput& options) {
  add_rules(command, options);
  add_start(command, options);
  add_terms(command, options.evolution);
}

OrganOptions organ_options(const InputOptions& options) {
  const OrganInput& organ = options.organ;
  OrganOptions result;
  if (options.segmentation.gaussian_sigma_pixels > 0)
    result.start.push_back(GaussianStep{options.segmentation.gaussian_sigma_pixels});
  if (!organ.diffusion.empty()) {
    DiffusionOptions diffusion{.contrast = organ.diffusion[0]};
    if (organ.diffusion.size() > 1) diffusion.steps = static_cast<int>(organ.diffusion[1]);
    result.start.push_back(DiffusionStep{diffusion});
  }
  add_rule_step(options, result.start);
  bool is_connected = false;
  for (const std::string& text : organ.start) {
    result.start.push_back(text.starts_with("labels:") ? read_labels_step(text) : parse_start_step(text));
    is_connected = is_connected || std::holds_alternative<ConnectedStep>(result.start.back());
  }
  if (organ.open_mm > 0) result.start.push_back(OpenStep{organ.open_mm});
  if (!organ.seeds.empty() && !is_connected) result.start.push_back(ConnectedStep{});
  if (organ.close_mm > 0) result.start.push_back(CloseStep{organ.close_mm});
  if (organ.hull) result.start.push_back(HullStep{});
  if (options.segmentation.fill_holes) result.start.push_back(FillHolesStep{});
  if (options.segmentation.largest) result.start.push_back(LargestStep{});
  for (const std::string& text : organ.seeds) result.seeds.push_back(parse_seed(text));
  result.propagate_mm = organ.propagate_mm;
  result.in_volume = organ.in_volume;
  result.evolution = organ.evolution;
  result.evolution.curvature = options.segmentation.curvature;
  result.evolution.max_steps = options.segmentation.max_steps;
  return result;
}

}  // namespace isostack::cli
