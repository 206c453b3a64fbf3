#include "segmentation/organ_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "recon/geometry/errors.h"
#include "segmentation/for_each_slice.h"
#include "segmentation/number_text.h"
#include "segmentation/region.h"
#include "segmentation/shape_steps.h"
#include "segmentation/stack_checks.h"

namespace isostack {

namespace {

template <class Step>
bool contains(const std::vector<StartStep>& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const auto& step) { return std::holds_alternative<Step>(step); });
}

bool needs_order(const OrganOptions& options, const std::vector<StartStep>& steps) {
  return options.in_volume || options.propagate_mm > 0 || contains<ConnectedStep>(steps) ||
         contains<LargestStep>(steps);
}

/// The distance between planes of a volume. Throws GeometryError unless it is the same everywhere, along the normal.
double even_distance_mm(const OrganScene& scene) {
  const std::size_t count = scene.order.size();
  if (count < 2) throw GeometryError(scene.stack.name, "a volume needs two slices", "leave out `volume`");
  const double mean_mm = (scene.positions_mm.back() - scene.positions_mm.front()) / static_cast<double>(count - 1);
  const Eigen::Vector3d step_mm = mean_mm * scene.pose(0).normal();
  for (std::size_t k = 1; k < count; ++k) {
    const Eigen::Vector3d between_mm = scene.pose(k).origin_mm - scene.pose(k - 1).origin_mm;
    const double off_mm = std::min((between_mm - step_mm).norm(), (between_mm + step_mm).norm());
    if (off_mm > 0.02 * std::abs(mean_mm) + 0.01)
      throw GeometryError(scene.slice(k).name,
                          "it does not lie straight above " + scene.slice(k - 1).name + " at the stack's distance of " +
                              number_text(std::abs(mean_mm), 4) + " mm",
                          "leave out `volume`: slice by slice works with gaps and tilt");
  }
  return std::abs(mean_mm);
}

std::vector<OrganRegion> organs_of(const OrganOptions& options, const OrganScene& scene) {
  std::vector<OrganRegion> organs;
  std::vector<std::size_t> plane_of(scene.order.size());
  for (std::size_t k = 0; k < scene.order.size(); ++k) plane_of[scene.order[k]] = k;
  for (const Seed& seed : options.seeds) {
    const std::string name = seed.name.empty() ? scene.stack.name : seed.name;
    auto organ = std::find_if(organs.begin(), organs.end(), [&](const auto& known) { return known.name == name; });
    if (organ == organs.end()) {
      organs.push_back({.name = name, .seeds = {}, .seed_pixels = {}, .range = std::nullopt, .phi = {}});
      organ = organs.end() - 1;
    }
    SeedPixel pixel = pixel_of(seed, scene.stack);
    pixel.slice = plane_of[pixel.slice];
    organ->seeds.push_back(seed);
    organ->seed_pixels.push_back(pixel);
  }
  if (organs.empty())
    organs.push_back({.name = scene.stack.name, .seeds = {}, .seed_pixels = {}, .range = std::nullopt, .phi = {}});
  return organs;
}

/// Nothing anywhere; then rules replace it.
void start_empty(OrganRegion& organ, const OrganScene& scene) {
  for (const auto& grey : scene.grey) organ.phi.push_back(Image<float>::Constant(grey.rows(), grey.cols(), -1));
}

GreyRange otsu_range(const OrganScene& scene, const OtsuStep& step) {
  const OtsuClasses classes = otsu_classes(scene.grey);
  if (std::isnan(classes.level))
    throw InputError(scene.stack.name, "the images are constant and have no organ to find", "give other images");
  const double inside = step.brighter_inside ? classes.bright_mean : classes.dark_mean;
  const double outside = step.brighter_inside ? classes.dark_mean : classes.bright_mean;
  const double level = step.share ? outside + *step.share * (inside - outside) : classes.level;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return step.brighter_inside ? GreyRange{level, infinity} : GreyRange{-infinity, level};
}

std::vector<GreyRange> ranges_of(const StartStep& rule, const OrganScene& scene) {
  std::vector<GreyRange> ranges;
  for (const OrganRegion& organ : scene.organs) {
    if (const auto* range = std::get_if<RangeStep>(&rule)) {
      ranges.push_back(range->range);
    } else if (const auto* otsu = std::get_if<OtsuStep>(&rule)) {
      ranges.push_back(ranges.empty() ? otsu_range(scene, *otsu) : ranges.front());
    } else if (const auto* like = std::get_if<SeedRangeStep>(&rule)) {
      if (organ.seeds.empty())
        throw InputError("start step 'like-seeds'", "there is no seed to be like", "give --seed X,Y,Z");
      GreyRange whole{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
      for (const SeedPixel& seed : organ.seed_pixels) {
        const GreyRange one = range_like_seed(scene.slice(seed.slice), scene.grey[seed.slice], seed, like->spread);
        whole = {std::min(whole.low, one.low), std::max(whole.high, one.high)};
      }
      ranges.push_back(whole);
    }
  }
  return ranges;
}

void apply_rule(const StartStep& rule, OrganScene& scene, const Progress& progress) {
  const std::vector<GreyRange> ranges = ranges_of(rule, scene);
  for (std::size_t i = 0; i < scene.organs.size(); ++i) {
    OrganRegion& organ = scene.organs[i];
    organ.range.reset();
    if (!ranges.empty()) organ.range = ranges[i];
    for_each_slice(scene.order.size(), progress, "segment", 0.1, 0.2, [&](std::size_t k) {
      const auto& grey = scene.grey[k];
      organ.phi[k] = organ.range ? depth_in_range(grey, *organ.range)
                                 : region_of_labels(std::get<LabelStep>(rule), scene.pose(k),
                                                    {static_cast<int>(grey.cols()), static_cast<int>(grey.rows())});
    });
    if (organ.range) require_crossing(scene.stack.name, scene.grey, *organ.range, organ.phi);
  }
}

}  // namespace

OrganScene prepare_scene(const SliceStack& stack, const OrganOptions& options, const std::vector<StartStep>& steps,
                         const Progress& progress) {
  require_segmentable(stack);
  OrganScene scene{.stack = stack, .order = {}, .positions_mm = {}, .grey = {}, .organs = {}, .remarks = {}};
  scene.order.resize(stack.slices.size());
  std::iota(scene.order.begin(), scene.order.end(), std::size_t{0});
  if (needs_order(options, steps)) {
    scene.order = stacking_order(stack);
    const std::vector<double> positions_mm = positions_along_normal_mm(stack.slices);
    for (const std::size_t i : scene.order) scene.positions_mm.push_back(positions_mm[i]);
  }
  if (options.in_volume) scene.plane_distance_mm = even_distance_mm(scene);
  for (const std::size_t i : scene.order) scene.grey.push_back(stack.slices[i].pixels);
  scene.organs = organs_of(options, scene);
  for (OrganRegion& organ : scene.organs) start_empty(organ, scene);

  bool has_rule = false;
  for (const StartStep& step : steps) {
    if (is_rule(step)) {
      apply_rule(step, scene, progress);
      has_rule = true;
    } else if (is_filter(step)) {
      if (has_rule)
        throw InputError("start steps", "a filter comes after the rule that uses its grey values",
                         "put gaussian and diffusion first");
      for_each_slice(scene.order.size(), progress, "segment", 0, 0.1,
                     [&](std::size_t k) { apply_filter(step, scene.pose(k).spacing_mm, scene.grey[k]); });
    }
  }
  return scene;
}

std::vector<SeedPixel> seeds_within(const OrganRegion& organ, const OrganScene& scene) {
  std::vector<SeedPixel> seeds;
  for (std::size_t i = 0; i < organ.seeds.size(); ++i) {
    const SeedPixel& seed = organ.seed_pixels[i];
    const Image<float>& phi = organ.phi[seed.slice];
    SeedPixel nearest = seed;
    double nearest_pixels = std::numeric_limits<double>::infinity();
    constexpr Eigen::Index reach = 3;
    for (Eigen::Index row = std::max<Eigen::Index>(0, seed.row - reach);
         row <= std::min(phi.rows() - 1, seed.row + reach); ++row)
      for (Eigen::Index column = std::max<Eigen::Index>(0, seed.column - reach);
           column <= std::min(phi.cols() - 1, seed.column + reach); ++column) {
        const double pixels =
            std::hypot(static_cast<double>(row - seed.row), static_cast<double>(column - seed.column));
        if (phi(row, column) < 0 || pixels >= nearest_pixels) continue;
        nearest_pixels = pixels;
        nearest = {seed.slice, row, column};
      }
    if (nearest_pixels > static_cast<double>(reach)) {
      std::string grey = number_text(scene.grey[seed.slice](seed.row, seed.column), 4);
      if (organ.range)
        grey.append(", the range is " + number_text(organ.range->low, 4))
            .append(" to " + number_text(organ.range->high, 4));
      throw InputError(
          seed_text(organ.seeds[i]),
          "on " + scene.slice(seed.slice).name + " the region does not reach it (its grey value is " + grey + ")",
          "seed the organ's middle, or try another --range or --level, or a smaller --open");
    }
    seeds.push_back(nearest);
  }
  return seeds;
}

}  // namespace isostack
