#include "segmentation/seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/geometry/errors.h"
#include "segmentation/flood.h"
#include "segmentation/number_text.h"

namespace isostack {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Half the distance to the nearest parallel slice; 10 mm, a thick slice, when there is none.
double half_gap_mm(const SliceStack& stack, const Slice& slice) {
  double gap_mm = infinity;
  for (const Slice& other : stack.slices) {
    if (&other == &slice || !are_parallel(other.pose, slice.pose)) continue;
    const double distance_mm = std::abs(slice.pose.signed_distance_mm(other.pose.origin_mm));
    if (distance_mm > 1e-3) gap_mm = std::min(gap_mm, distance_mm);
  }
  return gap_mm < infinity ? gap_mm / 2 : 10;
}

struct Statistics {
  double sum = 0, sum_of_squares = 0, count = 0;
  void add(double value) {
    sum += value;
    sum_of_squares += value * value;
    ++count;
  }
  double mean() const { return sum / count; }
  double deviation() const { return std::sqrt(std::max(0.0, sum_of_squares / count - mean() * mean())); }
};

/// Of the box of 4 mm, at least 2 pixels, to each side: fewer pixels say too little about a smoothed image's noise.
Statistics around(const Image<float>& image, const SeedPixel& seed, const Eigen::Vector2d& spacing_mm) {
  const Eigen::Index x = std::max<Eigen::Index>(2, std::lround(4 / spacing_mm.x()));
  const Eigen::Index y = std::max<Eigen::Index>(2, std::lround(4 / spacing_mm.y()));
  Statistics statistics;
  for (Eigen::Index row = std::max<Eigen::Index>(0, seed.row - y); row <= std::min(image.rows() - 1, seed.row + y);
       ++row)
    for (Eigen::Index column = std::max<Eigen::Index>(0, seed.column - x);
         column <= std::min(image.cols() - 1, seed.column + x); ++column)
      statistics.add(image(row, column));
  return statistics;
}

/// Of what is connected to the seed within the range and the radius.
Statistics connected_around(const Image<float>& image, const SeedPixel& seed, const GreyRange& range,
                            const Eigen::Vector2d& spacing_mm) {
  const double radius_mm = std::max(10.0, 3 * spacing_mm.maxCoeff());
  Mask entered = Mask::Zero(image.rows(), image.cols());
  Statistics statistics;
  flood_from(seed.row, seed.column, image.rows(), image.cols(), [&](Eigen::Index row, Eigen::Index column) {
    const double away_mm = std::hypot(static_cast<double>(column - seed.column) * spacing_mm.x(),
                                      static_cast<double>(row - seed.row) * spacing_mm.y());
    if (entered(row, column) || away_mm > radius_mm || range.depth(image(row, column)) < 0) return false;
    entered(row, column) = 1;
    statistics.add(image(row, column));
    return true;
  });
  return statistics;
}

}  // namespace

std::string seed_text(const Seed& seed) {
  const Eigen::Vector3d& at = seed.position_mm;
  std::string text = "seed " + number_text(at.x()) + "," + number_text(at.y()) + "," + number_text(at.z());
  if (!seed.name.empty()) text.append(" (").append(seed.name).append(")");
  return text;
}

SeedPixel pixel_of(const Seed& seed, const SliceStack& stack) {
  double nearest_mm = infinity, beside_mm = infinity;
  std::size_t nearest = 0;
  Eigen::Vector2d pixel;
  for (std::size_t i = 0; i < stack.slices.size(); ++i) {
    const Slice& slice = stack.slices[i];
    const double off_mm = std::abs(slice.pose.signed_distance_mm(seed.position_mm));
    const Eigen::Vector2d at = slice.pose.slice_to_pixel(slice.pose.world_to_slice(seed.position_mm));
    const bool is_beside = at.minCoeff() < -0.5 || at.x() >= static_cast<double>(slice.pixels.cols()) - 0.5 ||
                           at.y() >= static_cast<double>(slice.pixels.rows()) - 0.5;
    double& best_mm = is_beside ? beside_mm : nearest_mm;
    if (off_mm >= best_mm) continue;
    best_mm = off_mm;
    if (is_beside) continue;
    nearest = i;
    pixel = at;
  }
  const std::string remedy = "give X,Y,Z in mm in the patient (LPS, as in `info` and DICOM), not pixels";
  if (nearest_mm == infinity) throw InputError(seed_text(seed), "it lies beside the images of " + stack.name, remedy);
  const Slice& slice = stack.slices[nearest];
  if (nearest_mm > half_gap_mm(stack, slice) * 1.001)
    throw InputError(seed_text(seed),
                     "it lies " + number_text(nearest_mm, 3) + " mm off the nearest slice, " + slice.name, remedy);
  return {nearest, static_cast<Eigen::Index>(std::lround(pixel.y())),
          static_cast<Eigen::Index>(std::lround(pixel.x()))};
}

GreyRange range_like_seed(const Slice& slice, const Image<float>& grey, const SeedPixel& seed, double spread) {
  // Without noise the deviation is zero; a two-hundredth of the image's contrast cannot be seen.
  const double least = (grey.maxCoeff() - grey.minCoeff()) / 200;
  if (!(least > 0))
    throw InputError(slice.name, "the image is constant and has no organ to find",
                     "leave this slice out or seed another");
  Statistics statistics = around(grey, seed, slice.pose.spacing_mm);
  GreyRange range{};
  for (int round = 0; round < 4; ++round) {
    const double reach = spread * std::max(statistics.deviation(), least);
    range = {statistics.mean() - reach, statistics.mean() + reach};
    const Statistics next = connected_around(grey, seed, range, slice.pose.spacing_mm);
    if (next.count == 0) break;
    statistics = next;
  }
  return range;
}

}  // namespace isostack
