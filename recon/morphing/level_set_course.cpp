#include "recon/morphing/level_set_course.h"

#include <algorithm>
#include <cmath>

#include "segmentation/lattice.h"
#include "segmentation/pieces.h"

namespace isostack {

namespace {

bool is_inside(float distance_mm) { return distance_mm >= 0; }

/// What grows along a course, one value a step; never falls.
std::vector<double> pace(const LevelSetCourse& course, FramePacing pacing) {
  std::vector<double> values;
  double least_rms = course.steps.front().rms_mm;
  for (const LevelSetStep& step : course.steps) {
    least_rms = std::min(least_rms, step.rms_mm);  // it rises when parts that were near have vanished
    values.push_back(pacing == FramePacing::time              ? step.time
                     : pacing == FramePacing::volume_fraction ? step.matched_fraction
                                                              : -least_rms);
  }
  return values;
}

}  // namespace

template <int D>
NodeCounts<D>::NodeCounts(const Field<D>& start, const Field<D>& target,
                          const std::vector<UnsharedRegion>& out_of_reach)
    : target_(target) {
  for (std::size_t node = 0; node < target.values.size(); ++node) {
    const bool in_target = is_inside(target.values[node]), in_start = is_inside(start.values[node]);
    target_inside_ += in_target;
    shared_ += in_target && in_start;
    wrong_ += in_target != in_start;
    deep_and_wrong_ += in_target != in_start && is_deep(node);
  }
  first_wrong_ = wrong_;
  for (const UnsharedRegion& region : out_of_reach)
    for (const std::size_t node : region.nodes) deep_and_wrong_ -= is_deep(node);
}

template <int D>
bool NodeCounts<D>::is_deep(std::size_t node) const {
  return std::abs(target_.values[node]) > target_.smallest_spacing_mm() / 2;
}

template <int D>
void NodeCounts<D>::changed_side(std::size_t node, bool is_inside_now) {
  const bool in_target = is_inside(target_.values[node]);
  const long wrong = in_target != is_inside_now ? 1 : -1;
  ++changes_;
  wrong_ += wrong;
  if (in_target) shared_ += is_inside_now ? 1 : -1;
  if (is_deep(node)) deep_and_wrong_ += wrong;
}

template <int D>
double NodeCounts<D>::shared_fraction() const {
  return target_inside_ > 0 ? static_cast<double>(shared_) / static_cast<double>(target_inside_) : 0;
}

template <int D>
double NodeCounts<D>::matched_fraction() const {
  return first_wrong_ > 0 ? 1 - static_cast<double>(wrong_) / static_cast<double>(first_wrong_) : 1;
}

template class NodeCounts<2>;
template class NodeCounts<3>;

template <int D>
CurveDistance distance_on_curve(const Field<D>& phi, const Field<D>& distance,
                                const std::vector<std::size_t>& beside_curve) {
  struct Sum {
    double squares = 0, largest = 0;
    std::size_t count = 0;
  };
  const Lattice<D> lattice(phi);
  const Pieces pieces{beside_curve.size(), 1 << 13};
  std::vector<Sum> sums(pieces.number());
  pieces.for_each([&](std::size_t piece, std::size_t first, std::size_t last) {
    Sum& sum = sums[piece];
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t node = beside_curve[i];
      const double here = phi.values[node];
      if (here < 0) continue;  // each edge once, from its inner end
      lattice.for_each_neighbour(lattice.sides_of(node), [&](int, std::ptrdiff_t step) {
        const std::size_t next = lattice.moved(node, step);
        if (is_inside(phi.values[next])) return;
        const double share = here / (here - static_cast<double>(phi.values[next]));
        const double mm = (1 - share) * static_cast<double>(distance.values[node]) +
                          share * static_cast<double>(distance.values[next]);
        sum.squares += mm * mm;
        sum.largest = std::max(sum.largest, std::abs(mm));
        ++sum.count;
      });
    }
  });
  Sum all;
  for (const Sum& sum : sums)
    all = {all.squares + sum.squares, std::max(all.largest, sum.largest), all.count + sum.count};
  return {all.count > 0 ? std::sqrt(all.squares / static_cast<double>(all.count)) : 0, all.largest};
}

template CurveDistance distance_on_curve(const Field<2>&, const Field<2>&, const std::vector<std::size_t>&);
template CurveDistance distance_on_curve(const Field<3>&, const Field<3>&, const std::vector<std::size_t>&);

CoursePlace place_on(const LevelSetCourse& course, FramePacing pacing, double share) {
  const std::size_t last = course.steps.size() - 1;
  if (share >= 1 || last == 0) return {last, 0};
  if (share <= 0) return {0, 0};
  std::vector<double> values = pace(course, pacing);
  if (!(values.back() > values.front())) values = pace(course, FramePacing::time);
  const double wanted = values.front() + share * (values.back() - values.front());
  const auto after = std::upper_bound(values.begin() + 1, values.end(), wanted);
  if (after == values.end()) return {last, 0};
  const auto step = static_cast<std::size_t>(after - values.begin()) - 1;
  return {step, std::clamp((wanted - values[step]) / (values[step + 1] - values[step]), 0.0, 1.0 - 1e-9)};
}

}  // namespace isostack
