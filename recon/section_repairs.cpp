#include "recon/section_repairs.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "recon/metrics/contour_distance.h"
#include "recon/surface/plane_section.h"

namespace isostack {

namespace {

constexpr double step_pixels = 0.25;

/// Points of a contour with its normal, corners and places between them.
std::vector<ContourSample> dense_samples(const Contour& contour, std::size_t slice, std::size_t index, double step_mm) {
  std::vector<ContourSample> samples;
  const auto& points = contour.points_mm;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d &a = points[i], &b = points[(i + 1) % points.size()];
    const Eigen::Vector2d along = b - a;
    const Eigen::Vector2d inward = Eigen::Vector2d(-along.y(), along.x()).stableNormalized();
    const auto parts = static_cast<int>(std::max(1.0, std::ceil(along.norm() / step_mm)));
    for (int k = 0; k < parts; ++k) samples.push_back({slice, index, a + along * k / parts, inward});
  }
  return samples;
}

struct Mean {
  double sum = 0, count = 0;
  void add(double value) { sum += value, count += 1; }
};

SectionDeviations deviations_on(const ContourSlice& slice, std::size_t index, const std::vector<Contour>& section,
                                double tolerance_pixels, Mean& distances_pixels) {
  SectionDeviations found;
  const double pixel_mm = slice.pose.spacing_mm.minCoeff(), tolerance_mm = tolerance_pixels * pixel_mm;
  const auto distance_to = [](const std::vector<Contour>& curves) {
    return curves.empty() ? std::optional<ContourDistance>() : std::optional<ContourDistance>(std::in_place, curves);
  };
  const std::optional<ContourDistance> to_section = distance_to(section), to_contours = distance_to(slice.contours);
  for (std::size_t c = 0; c < slice.contours.size(); ++c)
    for (const ContourSample& sample : dense_samples(slice.contours[c], index, c, step_pixels * pixel_mm)) {
      const double distance =
          to_section ? to_section->to(sample.point_in_slice_mm) : std::numeric_limits<double>::infinity();
      if (to_section) distances_pixels.add(distance / pixel_mm);
      if (distance <= tolerance_mm) continue;
      found.missed.push_back(sample);
      found.missed_by_mm.push_back(distance);
    }
  for (const Eigen::Vector2d& p : points_along(section, step_pixels * pixel_mm)) {
    const double distance = to_contours ? to_contours->to(p) : pixel_mm;
    if (to_contours && distance <= tolerance_mm) continue;
    found.stray.push_back({index, p, is_inside(slice.contours, p) ? distance : -distance});
  }
  return found;
}

}  // namespace

SectionDeviations section_deviations(const TriangleMesh& surface, const ContourStack& contours,
                                     double tolerance_pixels) {
  std::vector<SectionDeviations> on_slice(contours.slices.size());
  std::vector<Mean> distances(contours.slices.size());
  tbb::parallel_for(std::size_t{0}, on_slice.size(), [&](std::size_t i) {
    const ContourSlice& slice = contours.slices[i];
    on_slice[i] = deviations_on(slice, i, plane_section(surface, slice.pose), tolerance_pixels, distances[i]);
  });
  SectionDeviations all;
  for (const SectionDeviations& found : on_slice) {
    all.missed.insert(all.missed.end(), found.missed.begin(), found.missed.end());
    all.missed_by_mm.insert(all.missed_by_mm.end(), found.missed_by_mm.begin(), found.missed_by_mm.end());
    all.stray.insert(all.stray.end(), found.stray.begin(), found.stray.end());
  }
  Mean total;
  for (const Mean& mean : distances) total.sum += mean.sum, total.count += mean.count;
  all.mean_pixels = total.count > 0 ? total.sum / total.count : 0;
  return all;
}

std::vector<StrayPoint> farthest_strays(std::vector<StrayPoint> strays, double least_spacing_mm, std::size_t most) {
  std::stable_sort(strays.begin(), strays.end(), [](const StrayPoint& a, const StrayPoint& b) {
    return std::abs(a.distance_mm) > std::abs(b.distance_mm);
  });
  std::vector<StrayPoint> chosen;
  for (const StrayPoint& candidate : strays) {
    if (chosen.size() == most) break;
    const bool covered = std::any_of(chosen.begin(), chosen.end(), [&](const StrayPoint& c) {
      const double reach_mm = std::max(least_spacing_mm, 0.5 * std::abs(c.distance_mm));
      return c.slice == candidate.slice && (c.point_in_slice_mm - candidate.point_in_slice_mm).norm() < reach_mm;
    });
    if (!covered) chosen.push_back(candidate);
  }
  return chosen;
}

}  // namespace isostack
