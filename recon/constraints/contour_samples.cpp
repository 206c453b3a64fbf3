#include "recon/constraints/contour_samples.h"

#include <algorithm>
#include <cmath>

namespace isostack {

namespace {

using Eigen::Vector2d;

/// A contour with the measures the thinning needs, one entry per point.
struct MeasuredContour {
  std::size_t slice;
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

MeasuredContour measured(const Contour& contour, std::size_t slice, double pixel_mm) {
  MeasuredContour result{slice, &contour, pixel_mm, {}, {}, {}};
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

/// Samples per mm at point i when chords may deviate by tolerance_mm: spacing² = 8 · radius · tolerance.
double density(const MeasuredContour& contour, std::size_t i, double tolerance_mm, double min_spacing_mm) {
  return 1 / std::max(std::sqrt(8 * contour.radius_mm[i] * tolerance_mm), min_spacing_mm);
}

std::size_t wanted_samples(const MeasuredContour& contour, double tolerance_mm, double min_spacing_mm) {
  double count = 0;
  for (std::size_t i = 0; i < contour.step_mm.size(); ++i)
    count += contour.step_mm[i] * density(contour, i, tolerance_mm, min_spacing_mm);
  return std::clamp(static_cast<std::size_t>(std::ceil(count)), std::min<std::size_t>(8, contour.step_mm.size()),
                    contour.step_mm.size());
}

void append_samples(const MeasuredContour& contour, double tolerance_mm, double min_spacing_mm,
                    std::vector<ContourSample>& samples) {
  const std::size_t n = contour.step_mm.size();
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) total += contour.step_mm[i] * density(contour, i, tolerance_mm, min_spacing_mm);
  const double per_sample = total / static_cast<double>(wanted_samples(contour, tolerance_mm, min_spacing_mm));
  double credit = per_sample;  // the first point is always kept
  for (std::size_t i = 0; i < n; ++i) {
    if (credit >= per_sample * (1 - 1e-9)) {
      samples.push_back({contour.slice, contour.contour->points_mm[i], contour.inward[i]});
      credit -= per_sample;
    }
    credit += contour.step_mm[i] * density(contour, i, tolerance_mm, min_spacing_mm);
  }
}

}  // namespace

std::vector<ContourSample> sample_contours(const ContourStack& stack, const ContourSamplingOptions& options) {
  std::vector<MeasuredContour> contours;
  for (std::size_t s = 0; s < stack.slices.size(); ++s)
    for (const Contour& contour : stack.slices[s].contours)
      if (contour.points_mm.size() >= 3)
        contours.push_back(measured(contour, s, stack.slices[s].pose.spacing_mm.minCoeff()));

  const auto spacing = [&](const MeasuredContour& c) { return options.min_spacing_pixels * c.pixel_mm; };
  const auto total = [&](double tolerance_mm) {
    std::size_t count = 0;
    for (const MeasuredContour& c : contours) count += wanted_samples(c, tolerance_mm, spacing(c));
    return count;
  };
  double tolerance_mm = 0;
  if (total(0) > options.max_samples) {
    double low = 1e-6, high = 1e3;  // bisection on a logarithmic scale
    for (int step = 0; step < 60; ++step) {
      tolerance_mm = std::sqrt(low * high);
      (total(tolerance_mm) > options.max_samples ? low : high) = tolerance_mm;
    }
    tolerance_mm = high;
  }
  std::vector<ContourSample> samples;
  for (const MeasuredContour& c : contours) append_samples(c, tolerance_mm, spacing(c), samples);
  return samples;
}

}  // namespace isostack
