#include "segmentation/organ_rules.h"

#include <algorithm>
#include <limits>
#include <variant>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void require_one_rule(const OrganRules& rules) {
  const int count =
      int{rules.level.has_value()} + int{rules.range.has_value()} + int{rules.otsu} + int{rules.otsu_darker};
  if (count > 1)
    throw InputError("segmentation options", "there are several rules of grey values",
                     "give one of level, range, otsu and otsu_darker");
  if (rules.range && !(rules.range->low < rules.range->high))
    throw InputError("segmentation options", "the range's lower value is not below the upper", "give LO,HI");
}

void add_rule(const OrganRules& rules, std::vector<StartStep>& steps) {
  if (rules.level)
    steps.push_back(RangeStep{rules.darker ? GreyRange{-infinity, *rules.level} : GreyRange{*rules.level, infinity}});
  else if (rules.range)
    steps.push_back(RangeStep{*rules.range});
  else if (rules.otsu || rules.otsu_darker)
    steps.push_back(OtsuStep{rules.otsu});
  else if (rules.spread)
    steps.push_back(SeedRangeStep{*rules.spread});
}

}  // namespace

OrganOptions organ_options(const OrganRules& rules) {
  require_one_rule(rules);
  OrganOptions result;
  std::vector<StartStep>& steps = result.start;
  if (rules.gaussian_sigma_pixels > 0) steps.push_back(GaussianStep{rules.gaussian_sigma_pixels});
  if (rules.diffusion) steps.push_back(DiffusionStep{*rules.diffusion});
  add_rule(rules, steps);
  steps.insert(steps.end(), rules.start.begin(), rules.start.end());
  const bool is_connected = std::any_of(rules.start.begin(), rules.start.end(), [](const StartStep& step) {
    return std::holds_alternative<ConnectedStep>(step);
  });
  if (rules.open_mm > 0) steps.push_back(OpenStep{rules.open_mm});
  if (!rules.seeds.empty() && !is_connected) steps.push_back(ConnectedStep{});
  if (rules.close_mm > 0) steps.push_back(CloseStep{rules.close_mm});
  if (rules.hull) steps.push_back(HullStep{});
  if (rules.fill_holes) steps.push_back(FillHolesStep{});
  if (rules.largest) steps.push_back(LargestStep{});
  result.seeds = rules.seeds;
  result.propagate_mm = rules.propagate_mm;
  result.in_volume = rules.in_volume;
  result.evolution = rules.evolution;
  return result;
}

}  // namespace isostack
