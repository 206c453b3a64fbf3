#include "recon/morphing/level_set_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/morphing/level_set_course.h"
#include "segmentation/level_set.h"
#include "segmentation/speed_terms.h"

namespace isostack {

namespace {

template <int D>
class ApproachTerm : public SpeedTerm<D> {
 public:
  ApproachTerm(const Field<D>& target, const LevelSetMorphOptions& options)
      : target_(target), profile_(options.profile), width_mm_(options.width_pixels * target.smallest_spacing_mm()) {}
  bool is_constant_in_time() const override { return true; }
  double propagation(std::size_t node) const override {
    return approach_speed(profile_, width_mm_, static_cast<double>(target_.values[node]));
  }

 private:
  const Field<D>& target_;
  ApproachProfile profile_;
  double width_mm_;
};

/// Adds no speed: counts nodes.
template <int D>
class CountingTerm : public SpeedTerm<D> {
 public:
  explicit CountingTerm(NodeCounts<D>& counts) : counts_(counts) {}
  void changed_side(std::size_t node, bool is_inside_now) override { counts_.changed_side(node, is_inside_now); }

 private:
  NodeCounts<D>& counts_;
};

/// The values at a share of the step between two states.
template <int D>
Field<D> between(const Field<D>& before, const Field<D>& after, double share) {
  Field<D> mixed = before;
  const auto weight = static_cast<float>(share);
  std::transform(before.values.begin(), before.values.end(), after.values.begin(), mixed.values.begin(),
                 [weight](float a, float b) { return a + weight * (b - a); });
  return mixed;
}

template <int D>
void evolve_towards(const Field<D>& start, const Field<D>& target, const LevelSetMorphOptions& options,
                    NodeCounts<D>& counts, const Progress& progress, const LevelSetObserver<D>& observer) {
  ApproachTerm<D> approach(target, options);
  CountingTerm<D> counting(counts);
  LevelSetOptions evolution;
  evolution.max_steps = options.max_steps;
  evolution.tolerance_pixels = 0;
  evolution.band_pixels = narrow_band_pixels<D>;
  const auto result = evolve<D>(start, {&approach, &counting}, evolution,
                                {.on_report = {}, .is_cancelled = progress.is_cancelled}, observer);
  if (result.stop == LevelSetStop::vanished)
    throw SolveError("morph", "nothing is left of a shape that overlaps the next by less than a pixel",
                     "give a finer resolution, move the shapes over each other, or seed the parts");
}

}  // namespace

double approach_speed(ApproachProfile profile, double width_mm, double distance_mm) {
  switch (profile) {
    case ApproachProfile::identity:
      return distance_mm;
    case ApproachProfile::clamped:
      return std::clamp(distance_mm, -width_mm, width_mm);
    case ApproachProfile::tanh:
      return width_mm * std::tanh(distance_mm / width_mm);
  }
  return 0;
}

template <int D>
LevelSetRun<D>::LevelSetRun(Field<D> start, Field<D> target)
    : start_(std::move(start)), target_(std::move(target)), unshared_(unshared_regions(start_, target_)) {
  overlaps_ = NodeCounts<D>(start_, target_, {}).shared_fraction() > 0;
}

template <int D>
void LevelSetRun<D>::seed_unshared() {
  const double h_mm = start_.smallest_spacing_mm();
  for (const UnsharedRegion& region : unshared_) {
    const double radius_mm = std::clamp(region.depth_mm / 2, 0.5 * h_mm, 1.5 * h_mm);
    const auto centre = start_.position_of(region.deepest);
    for (const std::size_t node : region.nodes) {
      const auto position = start_.position_of(node);
      double squared = 0;
      for (int axis = 0; axis < D; ++axis)
        squared += std::pow((position[axis] - centre[axis]) * start_.spacing_mm[axis], 2);
      const auto in_ball = static_cast<float>(radius_mm - std::sqrt(squared));
      float& value = start_.values[node];
      value = region.is_inside ? std::max(value, in_ball) : std::min(value, -in_ball);
    }
  }
  seeded_ = true;
}

template <int D>
void LevelSetRun<D>::run(const LevelSetMorphOptions& options, const Progress& progress) {
  constexpr double patience = 20;  // units of time, in each of which a distance shrinks by e
  options_ = options;
  const double enough_mm = options.stop_rms_pixels * target_.smallest_spacing_mm();
  const double half_mm = target_.smallest_spacing_mm() / 2;
  NodeCounts<D> counts(start_, target_, seeded_ ? std::vector<UnsharedRegion>{} : unshared_);
  double last_change = 0;
  std::size_t last_changes = 0;
  const LevelSetObserver<D> observe = [&](const LevelSetState<D>& state) {
    const CurveDistance distance = distance_on_curve(state.phi, target_, state.beside_curve);
    course_.steps.push_back({.time = state.time_mm,
                             .shared_fraction = counts.shared_fraction(),
                             .matched_fraction = counts.matched_fraction(),
                             .rms_mm = distance.rms_mm,
                             .largest_mm = distance.largest_mm});
    progress.report("evolution", std::clamp(counts.matched_fraction(), 0.0, 1.0));
    if (counts.changes() != last_changes) last_change = state.time_mm;
    last_changes = counts.changes();
    const bool is_near = distance.rms_mm <= enough_mm && distance.largest_mm <= half_mm;
    course_.arrived = is_near && counts.deep_and_wrong() == 0;
    return !course_.arrived && !(is_near && state.time_mm - last_change > patience);
  };
  evolve_towards(start_, target_, options, counts, progress, observe);
}

template <int D>
void LevelSetRun<D>::fields_at(const std::vector<double>& shares, const Progress& progress, const See& see) const {
  std::vector<CoursePlace> places;
  for (const double share : shares) places.push_back(place_on(course_, options_.pacing, share));
  NodeCounts<D> counts(start_, target_, {});
  std::size_t step = 0, next = 0;
  std::optional<Field<D>> before;
  const auto is_wanted = [&](std::size_t at_step) { return next < places.size() && places[next].step == at_step; };
  const LevelSetObserver<D> observe = [&](const LevelSetState<D>& state) {
    for (; before && is_wanted(step - 1); ++next) see(next, between(*before, state.phi, places[next].share));
    for (; is_wanted(step) && places[next].share == 0; ++next) see(next, state.phi);
    before.reset();
    if (is_wanted(step)) before = state.phi;
    ++step;
    progress.report("frames", static_cast<double>(next) / static_cast<double>(places.size()));
    return next < places.size();
  };
  evolve_towards(start_, target_, options_, counts, progress, observe);
}

template class LevelSetRun<2>;
template class LevelSetRun<3>;

}  // namespace isostack
