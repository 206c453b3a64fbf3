#include "recon/metrics/leave_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"
#include "recon/morphing/signed_distance_stack.h"
#include "recon/surface/plane_section.h"
#include "segmentation/trace_contours.h"

namespace isostack {

namespace {

/// The slices' order along the normal, from the end at which they were given first; as given when not parallel.
std::vector<std::size_t> order_of(const ContourStack& contours, bool parallel) {
  std::vector<std::size_t> order(contours.slices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!parallel) return order;
  const SlicePose& first = contours.slices.front().pose;
  const auto position = [&](std::size_t i) { return first.signed_distance_mm(contours.slices[i].pose.origin_mm); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return position(a) < position(b); });
  if (position(contours.slices.size() - 1) < position(0)) std::reverse(order.begin(), order.end());
  return order;
}

ContourStack kept_slices(const ContourStack& contours, const SliceSplit& split) {
  ContourStack kept{.name = contours.name, .slices = {}};
  for (const std::size_t i : split.kept) kept.slices.push_back(contours.slices[i]);
  return kept;
}

/// Calls found_on(slice) for the contours a method has on each dropped slice, in the slice's frame.
template <class FoundOn>
SliceAgreement compare(const ContourStack& contours, const SliceSplit& split, FoundOn found_on) {
  SliceComparison comparison;
  for (const std::size_t i : split.dropped) {
    const ContourSlice& slice = contours.slices[i];
    const PixelLattice lattice = lattice_of(slice, contours);
    comparison.add(moved_to(lattice.pose, found_on(slice), slice.pose),
                   moved_to(lattice.pose, slice.contours, slice.pose), lattice);
  }
  return comparison.agreement();
}

SliceAgreement compare_interpolated(const ContourStack& contours, const SliceSplit& split,
                                    const SignedDistanceStack& distances, AlongNormal how) {
  const SlicePose& frame = distances.lattice.pose;
  return compare(contours, split, [&](const ContourSlice& slice) {
    const Image<float> image = interpolate(distances, frame.signed_distance_mm(slice.pose.origin_mm), how);
    return moved_to(slice.pose, trace_contours(image, frame.spacing_mm), frame);
  });
}

}  // namespace

SliceSplit split_slices(const ContourStack& contours, int every) {
  const std::string name = contours.name.empty() ? "contours" : contours.name;
  if (every < 2) throw InputError(name, "keeping every slice drops none", "give 2 or more");
  SliceSplit split;
  split.parallel = std::all_of(contours.slices.begin(), contours.slices.end(), [&](const ContourSlice& slice) {
    return are_parallel(slice.pose, contours.slices.front().pose);
  });
  const std::vector<std::size_t> order = order_of(contours, split.parallel);
  const auto step = static_cast<std::size_t>(every);
  for (std::size_t n = 0; n < order.size(); n += step) split.kept.push_back(order[n]);
  if (split.kept.size() < 2)
    throw InputError(name, fmt::format("keeping one slice of {} leaves fewer than two of its {}", every, order.size()),
                     "keep more of them");
  const std::size_t end = split.parallel ? (split.kept.size() - 1) * step : order.size();
  for (std::size_t n = 0; n < end; ++n)
    if (n % step != 0) split.dropped.push_back(order[n]);
  return split;
}

SliceAgreement agreement_on_dropped(const ContourStack& contours, const SliceSplit& split,
                                    const ReconstructOptions& options, ReconstructReport& report,
                                    const Progress& progress) {
  ReconstructOptions tolerant = options;  // what a study loses shows in its distances
  tolerant.accept_lost_contours = true;
  Reconstruction result = reconstruct(kept_slices(contours, split), tolerant, progress);
  report = std::move(result.report);
  progress.report("compare", 0);
  return compare(contours, split, [&](const ContourSlice& slice) { return plane_section(result.surface, slice.pose); });
}

LeaveOutStudy leave_out(const ContourStack& contours, int every, const ReconstructOptions& options,
                        const Progress& progress) {
  const SliceSplit split = split_slices(contours, every);
  const ContourStack kept = kept_slices(contours, split);
  LeaveOutStudy study{
      .every = every, .kept = split.kept.size(), .dropped = split.dropped.size(), .methods = {}, .report = {}};
  const Stopwatch watch;
  const SliceAgreement agreement = agreement_on_dropped(contours, split, options, study.report, progress);
  study.methods.push_back({"isostack", agreement, watch.seconds()});
  if (!split.parallel) return study;
  const Stopwatch distance_watch;
  const SignedDistanceStack distances = signed_distance_stack(kept, lattice_of(kept.slices.front(), kept));
  const double shared_seconds = distance_watch.seconds();
  for (const auto& [name, how] : {std::pair{"cubic", AlongNormal::cubic}, std::pair{"linear", AlongNormal::linear}}) {
    progress.report("compare", how == AlongNormal::cubic ? 0.3 : 0.6);
    const Stopwatch method_watch;
    const SliceAgreement interpolated = compare_interpolated(contours, split, distances, how);
    study.methods.push_back({name, interpolated, shared_seconds + method_watch.seconds()});
  }
  return study;
}

}  // namespace isostack
