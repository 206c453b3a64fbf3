#include "recon/constraints/crossings.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "recon/constraints/plane_lines.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

Contradiction::End end_of(const PlaneLine& line, const ContourCrossing& crossing, bool of_first) {
  return {line.at(crossing.place_mm), crossing.inward, of_first};
}

/// Walks along the line through both slices' crossings and calls visit(from, to) for each stretch on which they differ.
template <class Visit>
void walk(const PlaneLine& line, const LineRange& range, const std::vector<ContourCrossing>& first,
          const std::vector<ContourCrossing>& second, Visit visit) {
  bool in_first = false, in_second = false;
  Contradiction::End from{line.at(range.first_mm), Eigen::Vector3d::Zero(), false};
  std::size_t i = 0, j = 0;
  while (i < first.size() || j < second.size()) {
    const bool of_first = j == second.size() || (i < first.size() && first[i].place_mm <= second[j].place_mm);
    const ContourCrossing& next = of_first ? first[i++] : second[j++];
    if (next.place_mm >= range.last_mm) break;
    if (next.place_mm > range.first_mm) {
      const Contradiction::End to = end_of(line, next, of_first);
      if (in_first != in_second) visit(from, to);
      from = to;
    }
    bool& in_this = of_first ? in_first : in_second;
    in_this = !in_this;
  }
  if (in_first != in_second) visit(from, {line.at(range.last_mm), Eigen::Vector3d::Zero(), false});
}

double distance_between(const ContourSlice& a, const ContourSlice& b, const Eigen::Vector3d& point_mm) {
  double sum = 0;
  for (const ContourSlice* slice : {&a, &b})
    if (!slice->contours.empty())
      sum += std::abs(signed_distance_mm(slice->contours, slice->pose.world_to_slice(point_mm)));
  return sum;
}

std::optional<SlicePair> compare(const ContourStack& stack, std::size_t first, std::size_t second,
                                 const Eigen::AlignedBox3d& box, const CrossingOptions& options) {
  const ContourSlice &a = stack.slices[first], &b = stack.slices[second];
  if (a.contours.empty() && b.contours.empty()) return std::nullopt;
  const std::optional<PlaneLine> line = line_between(a.pose, b.pose);
  if (!line) return std::nullopt;
  const LineRange in_a = range_within(*line, a.pose, field_of_view(a, box));
  const LineRange in_b = range_within(*line, b.pose, field_of_view(b, box));
  const LineRange range{std::max(in_a.first_mm, in_b.first_mm), std::min(in_a.last_mm, in_b.last_mm)};
  if (range.empty()) return std::nullopt;
  const std::vector<ContourCrossing> of_a = crossings_along(*line, a), of_b = crossings_along(*line, b);
  SlicePair pair{.first = first,
                 .second = second,
                 .first_name = a.name,
                 .second_name = b.name,
                 .line_mm = range.length_mm(),
                 .places = {}};
  walk(*line, range, of_a, of_b, [&](const Contradiction::End& from, const Contradiction::End& to) {
    Contradiction place{.ends = {from, to}, .length_mm = (to.point_mm - from.point_mm).norm()};
    if (place.length_mm <= options.least_mm) return;
    place.distance_mm = distance_between(a, b, place.middle_mm());
    pair.disagreement_mm += place.length_mm;
    pair.largest_mismatch_mm = std::max(pair.largest_mismatch_mm, place.length_mm);
    pair.places.push_back(place);
  });
  const auto within = [&](const ContourCrossing& c) {
    return c.place_mm > range.first_mm && c.place_mm < range.last_mm;
  };
  const bool organ_is_near = !pair.places.empty() || std::any_of(of_a.begin(), of_a.end(), within) ||
                             std::any_of(of_b.begin(), of_b.end(), within);
  return organ_is_near ? std::optional(std::move(pair)) : std::nullopt;
}

/// Largest distance of a contour point of `a` within b's field of view from b's contours.
double farthest_mm(const ContourSlice& a, const ContourSlice& b, const Eigen::AlignedBox3d& box) {
  const Eigen::AlignedBox2d view = field_of_view(b, box);
  double farthest = 0;
  for (const Contour& contour : a.contours)
    for (const Eigen::Vector2d& point : contour.points_mm) {
      const Eigen::Vector2d in_b = b.pose.world_to_slice(a.pose.slice_to_world(point));
      if (view.contains(in_b)) farthest = std::max(farthest, std::abs(signed_distance_mm(b.contours, in_b)));
    }
  return farthest;
}

/// Throws GeometryError when the slices show the same plane, but not the same organ.
void require_same_contours_in_same_plane(const ContourSlice& a, const ContourSlice& b, const Eigen::AlignedBox3d& box) {
  const double pixel_mm = std::max(a.pose.spacing_mm.maxCoeff(), b.pose.spacing_mm.maxCoeff());
  if (!in_one_plane(a.pose, b.pose, 0.1 * pixel_mm)) return;
  const double apart_mm = std::max(farthest_mm(a, b, box), farthest_mm(b, a, box));
  if (apart_mm <= pixel_mm) return;
  const std::string by = std::isfinite(apart_mm) ? fmt::format("contours up to {:.1f} mm apart", apart_mm)
                                                 : std::string("the organ in only one of them");
  throw GeometryError(fmt::format("slices {} and {}", a.name, b.name), "they lie in the same plane with " + by,
                      "keep one of them");
}

}  // namespace

bool Contradiction::is_matched() const {
  return ends[0].of_first != ends[1].of_first && !ends[0].inward.isZero() && !ends[1].inward.isZero();
}

double Contradictions::disagreement_mm() const {
  double sum = 0;
  for (const SlicePair& pair : pairs) sum += pair.disagreement_mm;
  return sum;
}

double Contradictions::largest_mismatch_mm() const {
  double largest = 0;
  for (const SlicePair& pair : pairs) largest = std::max(largest, pair.largest_mismatch_mm);
  return largest;
}

Contradictions find_contradictions(const ContourStack& stack, const CrossingOptions& options) {
  const std::size_t count = stack.slices.size();
  const Eigen::AlignedBox3d box = box_of_contours(stack);
  Contradictions result;
  if (box.isEmpty()) return result;
  for (std::size_t a = 0; options.refuse_duplicates && a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b)
      require_same_contours_in_same_plane(stack.slices[a], stack.slices[b], box);

  std::vector<std::vector<SlicePair>> found(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t a) {
    for (std::size_t b = a + 1; b < count; ++b)
      if (std::optional<SlicePair> pair = compare(stack, a, b, box, options)) found[a].push_back(std::move(*pair));
  });
  for (std::vector<SlicePair>& pairs : found) std::move(pairs.begin(), pairs.end(), std::back_inserter(result.pairs));
  return result;
}

}  // namespace isostack
