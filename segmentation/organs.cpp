#include "segmentation/organs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recon/geometry/errors.h"
#include "segmentation/fast_marching.h"
#include "segmentation/for_each_slice.h"
#include "segmentation/keep_connected.h"
#include "segmentation/organ_scene.h"
#include "segmentation/propagate.h"
#include "segmentation/region.h"
#include "segmentation/shape_steps.h"
#include "segmentation/trace_contours.h"

namespace isostack {

namespace {

constexpr std::string_view stage = "segment";

void require(bool holds, const char* problem, const char* remedy) {
  if (!holds) throw InputError("segmentation options", problem, remedy);
}

bool makes_region(const StartStep& step) {
  const auto* solid = std::get_if<SolidStep>(&step);
  return is_rule(step) || (solid && solid->operation == SolidStep::Operation::add);
}

void check(const OrganOptions& options) {
  require(options.propagate_mm >= 0 && std::isfinite(options.propagate_mm), "the reach of --propagate is negative",
          "give mm, 0 for none");
  require(options.propagate_mm == 0 || !options.seeds.empty(), "propagation has no seed to begin at",
          "give --seed X,Y,Z");
  const EvolutionOptions& evolution = options.evolution;
  require(evolution.curvature >= 0 && std::isfinite(evolution.curvature),
          "the curvature weight is negative or not a number", "give a weight of 0 or more");
  require(evolution.region >= 0 && evolution.edge >= 0 && evolution.range_weight.value_or(0) >= 0 &&
              evolution.region_window_mm >= 0 && evolution.edge_contrast >= 0 && evolution.stay_mm >= 0,
          "a weight, window, contrast or distance of the evolution is negative", "give 0 or more");
  require(evolution.max_steps >= 0, "the number of level-set steps is negative", "give 0 or more");
  require(!(options.in_volume && options.propagate_mm > 0), "a volume is not propagated slice by slice",
          "give either --volume or --propagate");
  const bool makes_any = std::any_of(options.start.begin(), options.start.end(), makes_region);
  require(makes_any || !options.seeds.empty(), "nothing says where the organ is",
          "give a level, a range, Otsu, labels, a solid to add, or a seed");
  require(options.seeds.empty() || std::any_of(options.seeds.begin(), options.seeds.end(),
                                               [](const Seed& seed) { return seed.name != "-"; }),
          "all seeds are of what is not wanted", "give the organ a seed, too");
}

/// The steps with what is understood without being said.
std::vector<StartStep> completed(const OrganOptions& options) {
  std::vector<StartStep> steps = options.start;
  if (options.seeds.empty()) return steps;
  if (std::none_of(steps.begin(), steps.end(), makes_region)) {
    const auto after_filters = std::find_if_not(steps.begin(), steps.end(), is_filter);
    steps.insert(after_filters, SeedRangeStep{});
  }
  const auto is_connected = [](const StartStep& step) { return std::holds_alternative<ConnectedStep>(step); };
  if (std::none_of(steps.begin(), steps.end(), is_connected)) steps.push_back(ConnectedStep{});
  return steps;
}

std::vector<std::vector<Mask>> masks_of(const OrganScene& scene) {
  std::vector<std::vector<Mask>> masks;
  for (const OrganRegion& organ : scene.organs) {
    masks.emplace_back();
    for (const auto& phi : organ.phi) masks.back().push_back(inside_of(phi));
  }
  return masks;
}

void keep_connected(OrganScene& scene) {
  std::vector<std::vector<Mask>> masks = masks_of(scene);
  std::vector<std::vector<SeedPixel>> seeds;
  for (const OrganRegion& organ : scene.organs) seeds.push_back(seeds_within(organ, scene));
  keep_connected(masks, seeds, scene.positions_mm, scene.pose(0).spacing_mm);
  for (std::size_t i = 0; i < scene.organs.size(); ++i)
    for (std::size_t k = 0; k < scene.order.size(); ++k) impose(masks[i][k], scene.organs[i].phi[k]);
}

std::vector<SlicePose> poses_of(const OrganScene& scene) {
  std::vector<SlicePose> poses;
  for (std::size_t k = 0; k < scene.order.size(); ++k) poses.push_back(scene.pose(k));
  return poses;
}

/// No organ takes pixels that another one alone held before, as filling the holes of one that encloses another would.
void give_back(const std::vector<std::vector<Mask>>& before, OrganScene& scene) {
  for (std::size_t k = 0; k < scene.order.size(); ++k)
    for (std::size_t i = 0; i < scene.organs.size(); ++i) {
      Mask now = inside_of(scene.organs[i].phi[k]);
      for (std::size_t other = 0; other < scene.organs.size(); ++other)
        if (other != i) now = (before[other][k] > before[i][k]).select(Mask::Zero(now.rows(), now.cols()), now);
      impose(now, scene.organs[i].phi[k]);
    }
}

void apply_to_all(const StartStep& step, bool is_connected, OrganScene& scene, const OrganOptions& options,
                  const Progress& progress) {
  if (is_rule(step) || is_filter(step)) return;
  if (std::holds_alternative<ConnectedStep>(step)) {
    if (!scene.organs.front().seeds.empty()) keep_connected(scene);
    return;
  }
  const bool shares = is_connected && scene.organs.size() > 1;
  const auto before = shares ? masks_of(scene) : std::vector<std::vector<Mask>>{};
  for (OrganRegion& organ : scene.organs) {
    if (is_connected && !organ.is_wanted()) continue;
    if (std::holds_alternative<LargestStep>(step))
      keep_largest(organ.phi);
    else if (options.in_volume)
      apply_shape_step(step, poses_of(scene), scene.plane_distance_mm, organ.phi);
    else
      for_each_slice(scene.order.size(), progress, stage, 0.2, 0.3,
                     [&](std::size_t k) { apply_shape_step(step, scene.pose(k), organ.phi[k]); });
  }
  if (shares) give_back(before, scene);
}

void evolve(OrganRegion& organ, OrganScene& scene, const OrganOptions& options, const Progress& progress) {
  if (options.in_volume) {
    const Eigen::Vector2d& pixel = scene.pose(0).spacing_mm;
    const Eigen::Vector3d spacing_mm(pixel.x(), pixel.y(), scene.plane_distance_mm);
    const Progress of_steps{[&](std::string_view, double fraction) { progress.report(stage, 0.3 + 0.6 * fraction); },
                            progress.is_cancelled};
    organ.phi = planes_of(evolve_region<3>(field_of(organ.phi, spacing_mm), field_of(scene.grey, spacing_mm),
                                           organ.range, options.evolution, scene.stack.name, of_steps));
    return;
  }
  for_each_slice(scene.order.size(), progress, stage, 0.3, 0.9, [&](std::size_t k) {
    const Eigen::Vector2d& spacing_mm = scene.pose(k).spacing_mm;
    LevelSetObserver<2> observer;
    if (options.observer)
      observer = [&options, slice = scene.order[k]](const LevelSetState<2>& state) {
        options.observer(slice, state);
        return true;
      };
    organ.phi[k] = image_of(evolve_region<2>(field_of(organ.phi[k], spacing_mm), field_of(scene.grey[k], spacing_mm),
                                             organ.range, options.evolution, scene.slice(k).name, {}, observer));
  });
}

/// What holds for the start holds for the result: the evolution may open holes, drop crumbs and leave solids.
bool is_promise(const StartStep& step) {
  const auto* solid = std::get_if<SolidStep>(&step);
  return std::holds_alternative<FillHolesStep>(step) || std::holds_alternative<LargestStep>(step) ||
         (solid && solid->operation != SolidStep::Operation::add);
}

void make_distances(OrganScene& scene, bool in_volume) {
  constexpr double band_pixels = 6;
  for (OrganRegion& organ : scene.organs) {
    if (in_volume) {
      const Eigen::Vector2d& pixel = scene.pose(0).spacing_mm;
      Field<3> field = field_of(organ.phi, {pixel.x(), pixel.y(), scene.plane_distance_mm});
      redistance(field, band_pixels * field.smallest_spacing_mm());
      organ.phi = planes_of(field);
      continue;
    }
    for_each_slice(scene.order.size(), {}, stage, 0.9, 0.95, [&](std::size_t k) {
      Field<2> field = field_of(organ.phi[k], scene.pose(k).spacing_mm);
      redistance(field, band_pixels * field.smallest_spacing_mm());
      organ.phi[k] = image_of(field);
    });
  }
}

void part(OrganScene& scene) {
  for (std::size_t k = 0; k < scene.order.size(); ++k) {
    std::vector<Image<float>*> regions;
    for (OrganRegion& organ : scene.organs) regions.push_back(&organ.phi[k]);
    part_regions(regions);
  }
}

ContourStack traced(const OrganRegion& organ, const OrganScene& scene, const Progress& progress) {
  ContourStack result{organ.name, std::vector<ContourSlice>(scene.order.size())};
  for_each_slice(scene.order.size(), progress, stage, 0.95, 1, [&](std::size_t k) {
    const Slice& slice = scene.slice(k);
    result.slices[scene.order[k]] = {slice.name,
                                     slice.pose,
                                     {static_cast<int>(slice.pixels.cols()), static_cast<int>(slice.pixels.rows())},
                                     trace_contours(organ.phi[k], slice.pose.spacing_mm)};
  });
  return result;
}

}  // namespace

SegmentedOrgans segment_organs(const SliceStack& stack, const OrganOptions& options, const Progress& progress) {
  check(options);
  const std::vector<StartStep> steps = completed(options);
  OrganScene scene = prepare_scene(stack, options, steps, progress);
  if (options.propagate_mm > 0) {
    for (OrganRegion& organ : scene.organs)
      for (std::string& remark : propagate(organ, scene, steps, options)) scene.remarks.push_back(std::move(remark));
  } else {
    bool is_connected = false;
    for (const StartStep& step : steps) {
      apply_to_all(step, is_connected, scene, options, progress);
      is_connected = is_connected || std::holds_alternative<ConnectedStep>(step);
    }
    if (options.evolution.is_active())
      for (OrganRegion& organ : scene.organs)
        if (organ.is_wanted()) evolve(organ, scene, options, progress);
  }
  if (options.evolution.is_active())
    for (const StartStep& step : steps)
      if (is_promise(step)) apply_to_all(step, true, scene, options, progress);
  if (scene.organs.size() > 1 || options.keep_distances) make_distances(scene, options.in_volume);
  part(scene);

  SegmentedOrgans result;
  result.remarks = std::move(scene.remarks);
  for (OrganRegion& organ : scene.organs) {
    if (!organ.is_wanted()) continue;
    result.organs.push_back(traced(organ, scene, progress));
    if (!options.keep_distances) continue;
    result.distances_mm.emplace_back(scene.order.size());
    for (std::size_t k = 0; k < scene.order.size(); ++k)
      result.distances_mm.back()[scene.order[k]] = std::move(organ.phi[k]);
  }
  return result;
}

}  // namespace isostack
