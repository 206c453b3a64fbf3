#include "recon/metrics/slice_agreement.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "recon/metrics/contour_distance.h"
#include "recon/metrics/quantile.h"

namespace isostack {

namespace {

void add_distances(const std::vector<Contour>& from, const std::vector<Contour>& to, double step_mm,
                   std::vector<double>& distances_mm) {
  const ContourDistance distance(to);
  for (const Eigen::Vector2d& p : points_along(from, step_mm)) distances_mm.push_back(distance.to(p));
}

bool is_missed(const Contour& contour, const ContourDistance& to_found) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : contour.points_mm) box.extend(p);
  const double width_mm = box.sizes().maxCoeff();
  return std::all_of(contour.points_mm.begin(), contour.points_mm.end(),
                     [&](const Eigen::Vector2d& p) { return to_found.to(p) > width_mm; });
}

std::size_t count_missed(const std::vector<Contour>& truth, const std::vector<Contour>& found) {
  if (found.empty()) return truth.size();
  const ContourDistance to_found(found);
  return static_cast<std::size_t>(
      std::count_if(truth.begin(), truth.end(), [&](const Contour& contour) { return is_missed(contour, to_found); }));
}

std::size_t count(const Image<std::uint8_t>& mask) { return static_cast<std::size_t>((mask != 0).count()); }

}  // namespace

void SliceComparison::add(const std::vector<Contour>& found, const std::vector<Contour>& truth,
                          const PixelLattice& lattice) {
  ++slices_;
  const Image<std::uint8_t> a = pixels_inside(found, lattice.pose, lattice);
  const Image<std::uint8_t> b = pixels_inside(truth, lattice.pose, lattice);
  in_found_ += count(a);
  in_truth_ += count(b);
  in_both_ += count(a * b);
  missed_ += count_missed(truth, found);
  if (found.empty() || truth.empty()) {
    one_sided_ += found.empty() != truth.empty() ? 1 : 0;
    return;
  }
  const double step_mm = lattice.pose.spacing_mm.minCoeff() / 2;
  add_distances(found, truth, step_mm, to_truth_mm_);
  add_distances(truth, found, step_mm, to_found_mm_);
}

SliceAgreement SliceComparison::agreement() const {
  SliceAgreement result;
  result.slices = slices_;
  result.one_sided = one_sided_;
  result.missed = missed_;
  if (in_found_ + in_truth_ > 0)
    result.dice = 2.0 * static_cast<double>(in_both_) / static_cast<double>(in_found_ + in_truth_);
  if (to_truth_mm_.empty()) return result;
  result.has_distances = true;
  result.mean_mm = (mean(to_truth_mm_) + mean(to_found_mm_)) / 2;
  result.percentile95_mm = std::max(quantile(to_truth_mm_, 0.95), quantile(to_found_mm_, 0.95));
  result.largest_mm = std::max(quantile(to_truth_mm_, 1), quantile(to_found_mm_, 1));
  return result;
}

}  // namespace isostack
