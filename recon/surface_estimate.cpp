#include "recon/surface_estimate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace isostack {

namespace {

/// A slice of a set: where along the common normal, and what its contours enclose.
struct Band {
  double place_mm, length_mm, area_mm2;
};

double area_of(std::vector<Band> bands) {
  if (bands.size() < 2) return 0;
  std::sort(bands.begin(), bands.end(), [](const Band& a, const Band& b) { return a.place_mm < b.place_mm; });
  double area = bands.front().area_mm2 + bands.back().area_mm2;
  for (std::size_t i = 0; i + 1 < bands.size(); ++i) {
    const double gap_mm = bands[i + 1].place_mm - bands[i].place_mm;
    const double upright = gap_mm * (bands[i].length_mm + bands[i + 1].length_mm) / 2;
    area += std::hypot(upright, bands[i].area_mm2 - bands[i + 1].area_mm2);
  }
  return area;
}

double ellipsoid_area_mm2(const Eigen::Vector3d& sizes_mm) {  // K. Thomsen's formula, 1 % off at most
  constexpr double p = 1.6075;
  const Eigen::Array3d semi = sizes_mm.array() / 2;
  const double mean =
      (std::pow(semi[0] * semi[1], p) + std::pow(semi[0] * semi[2], p) + std::pow(semi[1] * semi[2], p)) / 3;
  return 4 * std::numbers::pi * std::pow(mean, 1 / p);
}

}  // namespace

double estimated_area_mm2(const ContourStack& contours) {
  std::vector<SlicePose> sets;
  std::vector<std::vector<Band>> bands;
  Eigen::AlignedBox3d box;
  for (const ContourSlice& slice : contours.slices) {
    Band band{0, 0, 0};
    for (const Contour& contour : slice.contours) {
      band.length_mm += perimeter_mm(contour);
      band.area_mm2 += signed_area_mm2(contour);
      for (const Eigen::Vector2d& point : contour.points_mm) box.extend(slice.pose.slice_to_world(point));
    }
    constexpr double parallel_rad = 0.1;
    auto set = std::find_if(sets.begin(), sets.end(),
                            [&](const SlicePose& pose) { return are_parallel(pose, slice.pose, parallel_rad); });
    if (set == sets.end()) {
      set = sets.insert(sets.end(), slice.pose);
      bands.emplace_back();
    }
    band.place_mm = set->signed_distance_mm(slice.pose.origin_mm);
    bands[static_cast<std::size_t>(set - sets.begin())].push_back(band);
  }
  double largest = 0;
  for (const std::vector<Band>& set : bands) largest = std::max(largest, area_of(set));
  return sets.size() == 1 ? largest : std::max(largest, ellipsoid_area_mm2(box.sizes()));
}

}  // namespace isostack
