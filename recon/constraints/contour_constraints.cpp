#include "recon/constraints/contour_constraints.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "recon/constraints/surface_lean.h"

namespace isostack {

namespace {

struct PlacedPartner {
  Eigen::Vector2d point_in_slice_mm;
  double distance_mm;
};

/// Halves the offset until the partner is about as far from every contour as it was moved, on the
/// side it was moved to; nothing when the structure is thinner than an eighth of the offset.
std::optional<PlacedPartner> place_partner(const ContourSlice& slice, const ContourSample& sample, double offset_mm) {
  for (int halving = 0; halving < 4; ++halving, offset_mm /= 2) {
    const Eigen::Vector2d point = sample.point_in_slice_mm + offset_mm * sample.inward;
    const double distance = signed_distance_mm(slice.contours, point);
    if (distance / offset_mm > 0.7) return PlacedPartner{point, distance};
  }
  return std::nullopt;
}

}  // namespace

ContourConstraints signed_constraints(const ContourStack& stack, const std::vector<ContourSample>& samples,
                                      const ContourConstraintOptions& options) {
  std::vector<std::array<std::optional<PlacedPartner>, 2>> placed(samples.size());
  tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
    const ContourSlice& slice = stack.slices[samples[i].slice];
    const double offset_mm = options.offset_pixels * slice.pose.spacing_mm.minCoeff();
    placed[i] = {place_partner(slice, samples[i], offset_mm), place_partner(slice, samples[i], -offset_mm)};
  });

  ContourConstraints result;
  result.samples = samples;
  std::vector<Eigen::Vector3d> points;
  std::vector<double> values;
  for (const ContourSample& sample : samples) {
    points.push_back(stack.slices[sample.slice].pose.slice_to_world(sample.point_in_slice_mm));
    values.push_back(0);
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (const auto& partner : placed[i]) {
      if (!partner) continue;
      result.partners.push_back(
          {static_cast<Eigen::Index>(points.size()), static_cast<Eigen::Index>(i), partner->distance_mm});
      points.push_back(stack.slices[samples[i].slice].pose.slice_to_world(partner->point_in_slice_mm));
      values.push_back(partner->distance_mm);
    }
  result.constraints.points = Eigen::Map<const Eigen::MatrixXd>(points.empty() ? nullptr : points.front().data(), 3,
                                                                static_cast<Eigen::Index>(points.size()));
  result.constraints.values =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  return result;
}

double correct_for_oblique_cuts(const Eigen::Matrix3Xd& gradients_at_samples, const ContourStack& stack,
                                ContourConstraints& constraints) {
  // Below this a plane nearly touches the surface and its contour says little about the distance.
  constexpr double least_factor = 0.1;
  constexpr double smoothing_pixels = 2.5;  // wider than the steps of contours traced from labels
  double pixel_mm = std::numeric_limits<double>::infinity();
  for (const ContourSlice& slice : stack.slices) pixel_mm = std::min(pixel_mm, slice.pose.spacing_mm.minCoeff());
  const Eigen::Index samples = gradients_at_samples.cols();
  Eigen::Matrix3Xd plane_normals(3, samples);
  for (Eigen::Index i = 0; i < samples; ++i)
    plane_normals.col(i) = stack.slices[constraints.samples[static_cast<std::size_t>(i)].slice].pose.normal();
  const Eigen::VectorXd lean = smoothed_lean(gradients_at_samples, constraints.constraints.points.leftCols(samples),
                                             plane_normals, smoothing_pixels * pixel_mm);
  double largest_change = 0;
  for (const ContourConstraints::Partner& partner : constraints.partners) {
    const double across = lean[partner.sample];
    const double factor = std::clamp(std::sqrt(std::max(0.0, 1 - across * across)), least_factor, 1.0);
    double& value = constraints.constraints.values[partner.constraint];
    largest_change = std::max(largest_change, std::abs(factor - value / partner.in_plane_distance_mm));
    value = factor * partner.in_plane_distance_mm;
  }
  return largest_change;
}

void add_points(const std::vector<Eigen::Vector3d>& points_mm, const std::vector<double>& values_mm,
                ContourConstraints& constraints) {
  ConstraintSet& set = constraints.constraints;
  const Eigen::Index before = set.values.size(), added = static_cast<Eigen::Index>(points_mm.size());
  set.points.conservativeResize(3, before + added);
  set.values.conservativeResize(before + added);
  for (Eigen::Index i = 0; i < added; ++i) {
    set.points.col(before + i) = points_mm[static_cast<std::size_t>(i)];
    set.values[before + i] = values_mm[static_cast<std::size_t>(i)];
  }
}

}  // namespace isostack
