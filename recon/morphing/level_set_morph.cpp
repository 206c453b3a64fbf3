#include "recon/morphing/level_set_morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/geometry/pixel_lattice.h"
#include "recon/geometry/stopwatch.h"
#include "recon/morphing/level_set_leg.h"

namespace isostack {

namespace {

using Legs = std::vector<std::shared_ptr<LevelSetLeg>>;

struct LegPlace {
  std::size_t leg = 0;
  double share = 0;  ///< of its way
};

class LevelSetFrames : public MorphMethod {
 public:
  LevelSetFrames(Legs legs, KeyPlaces places) : legs_(std::move(legs)), places_(std::move(places)) {}

  std::vector<Shape> shapes_at(const std::vector<Eigen::VectorXd>& weights, const Progress& progress) const override {
    std::vector<LegPlace> places;
    for (const Eigen::VectorXd& one : weights) places.push_back(leg_place(one));
    std::vector<Shape> shapes(places.size());
    for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
      std::vector<std::size_t> frames;
      for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i].leg == leg) frames.push_back(i);
      if (frames.empty()) continue;
      std::sort(frames.begin(), frames.end(),
                [&](std::size_t a, std::size_t b) { return places[a].share < places[b].share; });
      std::vector<double> shares;
      for (const std::size_t frame : frames) shares.push_back(places[frame].share);
      std::vector<Shape> found = legs_[leg]->shapes_at(shares, progress);
      for (std::size_t i = 0; i < frames.size(); ++i) shapes[frames[i]] = std::move(found[i]);
    }
    return shapes;
  }

 private:
  /// A key shape itself is the start of the way to the next, the last one the end of the way to it.
  LegPlace leg_place(const Eigen::VectorXd& weights) const {
    const auto line = places_.coordinates.row(0);
    const double at = std::clamp(places_.place_at(weights)[0], line[0], line[line.size() - 1]);
    Eigen::Index leg = 0;
    while (leg + 2 < line.size() && at >= line[leg + 1]) ++leg;
    const double share = (at - line[leg]) / (line[leg + 1] - line[leg]);
    return {static_cast<std::size_t>(leg), std::clamp(share, 0.0, 1.0)};
  }

  Legs legs_;
  KeyPlaces places_;
};

/// In the first one's pose.
std::vector<KeyShape> in_one_pose(std::vector<KeyShape> shapes) {
  const auto* first = std::get_if<ContourSlice>(&shapes.front().shape);
  if (first == nullptr) return shapes;
  const SlicePose pose = first->pose;
  const Eigen::Vector2i size_pixels = first->size_pixels;
  for (KeyShape& shape : shapes) {
    auto& figure = std::get<ContourSlice>(shape.shape);
    figure.contours = moved_to(pose, figure.contours, figure.pose);
    figure.pose = pose;
    figure.size_pixels = size_pixels;
  }
  return shapes;
}

void require_options(const std::vector<KeyShape>& shapes, const LevelSetMorphOptions& options) {
  if (!(options.width_pixels > 0) || !(options.stop_rms_pixels > 0) || options.max_steps < 1)
    throw InputError("morph", "a width, a threshold or a number of steps is not positive", "give numbers above 0");
  if (!options.landmarks.empty() && shapes.size() != 2)
    throw InputError("landmarks", fmt::format("they join two shapes, but there are {}", shapes.size()),
                     "morph two shapes at a time, or leave the landmarks out");
  if (!options.landmarks.empty() && options.transform == TransformKind::none)
    throw InputError("landmarks", "there is no transform to go by them", "ask for rigid, affine or warp");
}

void require_overlap(const LevelSetLeg& leg, const KeyShape& from, const KeyShape& to) {
  if (!leg.overlaps())
    throw InputError(to.name, fmt::format("no part of {} overlaps it, so that nothing can grow into it", from.name),
                     "move one over the other (a rigid transform does), or seed the parts");
}

double resolution_for(const std::vector<KeyShape>& shapes, double asked_mm) {
  if (asked_mm > 0) return asked_mm;
  if (dimension_of(shapes.front().shape) == 2) return common_pose(shapes).spacing_mm.minCoeff();
  return 1e-2 * box_of(shapes).sizes().maxCoeff();
}

}  // namespace

LevelSetPlan plan_level_set_morph(const std::vector<KeyShape>& given, const LevelSetMorphOptions& options,
                                  const Progress& progress) {
  require_morphable(given);
  require_distances(given);
  require_options(given, options);
  const Stopwatch watch;
  const std::vector<KeyShape> shapes = in_one_pose(given);
  LevelSetPlan plan;
  plan.places = key_places(shapes, KeyLayout::line);
  plan.report.method = "level-set";
  plan.report.resolution_mm = resolution_for(shapes, options.resolution_mm);
  plan.report.spacing_mm = box_of(shapes).sizes().maxCoeff() / 2;  // t has no length of its own here
  plan.report.landmarks = options.landmarks.size();
  for (std::size_t i = 0; i + 1 < shapes.size(); ++i) {
    progress.report("distances", static_cast<double>(i) / static_cast<double>(shapes.size() - 1));
    LegShapes leg{.from = shapes[i],
                  .to = shapes[i + 1],
                  .transform = transform_between(shapes[i], shapes[i + 1], common_pose(shapes), options.transform,
                                                 options.landmarks),
                  .options = options};
    leg.options.resolution_mm = plan.report.resolution_mm;
    plan.legs.push_back(dimension_of(leg.from.shape) == 2 ? figure_leg(std::move(leg))
                                                          : body_leg(std::move(leg), progress));
    if (options.unshared == UnsharedParts::leave) require_overlap(*plan.legs.back(), shapes[i], shapes[i + 1]);
    for (UnsharedPart& part : plan.legs.back()->unshared()) plan.unshared.push_back(std::move(part));
    if (options.unshared == UnsharedParts::seed) plan.legs.back()->seed_unshared();
  }
  plan.report.constraint_seconds = watch.seconds();
  return plan;
}

LevelSetMorph run_level_set_morph(LevelSetPlan plan, const Progress& progress) {
  const Stopwatch watch;
  std::vector<LevelSetCourse> courses;
  for (const auto& leg : plan.legs) {
    leg->run(progress);
    courses.push_back(leg->course());
    plan.report.solve.iterations += static_cast<int>(courses.back().steps.size()) - 1;
    if (courses.back().arrived) continue;
    plan.report.solve.converged = false;
    plan.report.solve.remark = fmt::format("from {} to {} the boundary stays {:.3g} mm (RMS) from the target",
                                           courses.back().from, courses.back().to, courses.back().steps.back().rms_mm);
  }
  plan.report.solve_seconds = watch.seconds();
  auto frames = std::make_shared<const LevelSetFrames>(std::move(plan.legs), plan.places);
  return {Morph(std::move(frames), std::move(plan.places), std::move(plan.report)), std::move(courses)};
}

Morph level_set_morph(const std::vector<KeyShape>& shapes, const LevelSetMorphOptions& options,
                      const Progress& progress) {
  return run_level_set_morph(plan_level_set_morph(shapes, options, progress), progress).morph;
}

}  // namespace isostack
