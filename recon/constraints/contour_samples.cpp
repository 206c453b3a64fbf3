#include "recon/constraints/contour_samples.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

using Eigen::Vector2d;

/// A contour with the measures the thinning needs, one entry per point.
struct MeasuredContour {
  std::size_t slice;
  std::size_t index;  ///< among the slice's contours
  const Contour* contour;
  double pixel_mm;
  std::vector<Vector2d> inward;
  std::vector<double> step_mm;    ///< to the next point
  std::vector<double> radius_mm;  ///< of curvature, smoothed over some pixels
};

/// The point `distance_mm` further along the curve (negative: back) from point i.
Vector2d point_along(const Contour& contour, std::size_t i, double distance_mm) {
  const auto& points = contour.points_mm;
  const std::size_t n = points.size();
  const std::size_t stride = distance_mm > 0 ? 1 : n - 1;
  double left = std::abs(distance_mm);
  for (std::size_t walked = 0, at = i; walked < n; ++walked) {
    const std::size_t next = (at + stride) % n;
    const double step = (points[next] - points[at]).norm();
    if (step >= left) return points[at] + (step > 0 ? left / step : 0.0) * (points[next] - points[at]);
    left -= step;
    at = next;
  }
  return points[i];
}

double circumradius(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const Vector2d ab = b - a, ac = c - a;
  const double twice_area = std::abs(ab.x() * ac.y() - ab.y() * ac.x());
  const double sides = ab.norm() * ac.norm() * (c - b).norm();
  return twice_area > 0 ? sides / (2 * twice_area) : 1e6;
}

MeasuredContour measured(const ContourSlice& on, std::size_t slice, std::size_t index) {
  const Contour& contour = on.contours[index];
  const double pixel_mm = on.pose.spacing_mm.minCoeff();
  MeasuredContour result{slice, index, &contour, pixel_mm, {}, {}, {}};
  const auto& points = contour.points_mm;
  const double length = perimeter_mm(contour);
  const double tangent_reach = std::min(pixel_mm, length / 8);
  const double curvature_reach = std::min(2 * pixel_mm, length / 6);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2d tangent = point_along(contour, i, tangent_reach) - point_along(contour, i, -tangent_reach);
    result.inward.push_back(Vector2d(-tangent.y(), tangent.x()).stableNormalized());  // the organ is on the left
    result.step_mm.push_back((points[(i + 1) % points.size()] - points[i]).norm());
    const double radius =
        circumradius(point_along(contour, i, -curvature_reach), points[i], point_along(contour, i, curvature_reach));
    result.radius_mm.push_back(std::clamp(radius, pixel_mm, 50 * pixel_mm));
  }
  return result;
}

/// Thinning of all contours together.
struct Thinning {
  double tolerance_mm = 0;
  double min_spacing_pixels = 0;
  std::size_t least_per_contour = 8;
};

/// Samples due on the way from point i to the next when chords may deviate by the tolerance:
/// spacing² = 8 · radius · tolerance. At most one, for there is no point in between to make up for it.
double samples_due(const MeasuredContour& contour, std::size_t i, const Thinning& thinning) {
  const double spacing_mm = std::max(std::sqrt(8 * contour.radius_mm[i] * thinning.tolerance_mm),
                                     thinning.min_spacing_pixels * contour.pixel_mm);
  return contour.step_mm[i] < spacing_mm ? contour.step_mm[i] / spacing_mm : 1;
}

std::size_t wanted_samples(const MeasuredContour& contour, const Thinning& thinning) {
  double count = 0;
  for (std::size_t i = 0; i < contour.step_mm.size(); ++i) count += samples_due(contour, i, thinning);
  return std::clamp(static_cast<std::size_t>(std::ceil(count)),
                    std::min(thinning.least_per_contour, contour.step_mm.size()), contour.step_mm.size());
}

void append_samples(const MeasuredContour& contour, const Thinning& thinning, std::vector<ContourSample>& samples) {
  const std::size_t n = contour.step_mm.size();
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) total += samples_due(contour, i, thinning);
  const double per_sample = total / static_cast<double>(wanted_samples(contour, thinning));
  double credit = per_sample;  // the first point is always kept
  for (std::size_t i = 0; i < n; ++i) {
    if (credit >= per_sample * (1 - 1e-9)) {
      samples.push_back({contour.slice, contour.index, contour.contour->points_mm[i], contour.inward[i]});
      credit -= per_sample;
    }
    credit += samples_due(contour, i, thinning);
  }
}

std::size_t total_samples(const std::vector<MeasuredContour>& contours, const Thinning& thinning) {
  std::size_t count = 0;
  for (const MeasuredContour& contour : contours) count += wanted_samples(contour, thinning);
  return count;
}

}  // namespace

std::vector<ContourSample> sample_contours(const ContourStack& stack, const ContourSamplingOptions& options) {
  std::vector<MeasuredContour> contours;
  for (std::size_t s = 0; s < stack.slices.size(); ++s)
    for (std::size_t c = 0; c < stack.slices[s].contours.size(); ++c)
      if (stack.slices[s].contours[c].points_mm.size() >= 3) contours.push_back(measured(stack.slices[s], s, c));
  if (contours.size() * 3 > options.max_samples)
    throw SolveError(stack.name.empty() ? "contours" : stack.name,
                     std::to_string(contours.size()) + " contours do not fit into " +
                         std::to_string(options.max_samples) + " boundary constraints",
                     "raise --max-constraints, or drop small parts with --largest or --gaussian");

  Thinning thinning{.tolerance_mm = 0, .min_spacing_pixels = options.min_spacing_pixels};
  if (total_samples(contours, thinning) > options.max_samples) {
    thinning.least_per_contour = std::clamp<std::size_t>(options.max_samples / (2 * contours.size()), 3, 8);
    double low = 1e-6, high = 1e6;  // mm; bisection on a logarithmic scale
    for (int step = 0; step < 60; ++step) {
      thinning.tolerance_mm = std::sqrt(low * high);
      (total_samples(contours, thinning) > options.max_samples ? low : high) = thinning.tolerance_mm;
    }
    thinning.tolerance_mm = high;
  }
  std::vector<ContourSample> samples;
  for (const MeasuredContour& contour : contours) append_samples(contour, thinning, samples);
  return samples;
}

}  // namespace isostack
