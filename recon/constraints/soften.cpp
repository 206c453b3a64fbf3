#include "recon/constraints/soften.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isostack {

namespace {

double distance_to_segment_mm(const Eigen::Vector3d& p, const SoftPlace& place) {
  const Eigen::Vector3d along = place.to_mm - place.from_mm;
  const double t = std::clamp((p - place.from_mm).dot(along) / std::max(along.squaredNorm(), 1e-30), 0.0, 1.0);
  return (place.from_mm + t * along - p).norm();
}

}  // namespace

std::vector<SoftPlace> soft_places(const Contradictions& contradictions, double pixel_mm,
                                   const SofteningOptions& options) {
  std::vector<SoftPlace> places;
  for (const SlicePair& pair : contradictions.pairs)
    for (const Contradiction& c : pair.places)
      if (c.distance_mm > options.least_pixels * pixel_mm)
        places.push_back({c.ends[0].point_mm, c.ends[1].point_mm, c.distance_mm});
  return places;
}

Eigen::VectorXd softening_of(const Eigen::MatrixXd& points, const std::vector<SoftPlace>& places, const Kernel& kernel,
                             const SofteningOptions& options) {
  std::vector<Eigen::Index> by_x(static_cast<std::size_t>(points.cols()));
  std::iota(by_x.begin(), by_x.end(), Eigen::Index{0});
  std::sort(by_x.begin(), by_x.end(), [&](Eigen::Index a, Eigen::Index b) { return points(0, a) < points(0, b); });
  Eigen::VectorXd smoothing = Eigen::VectorXd::Zero(points.cols());
  for (const SoftPlace& place : places) {
    const double reach_mm = options.reach * place.distance_mm;
    const double most = options.strength * std::pow(place.distance_mm, kernel.power);
    const double first_x = std::min(place.from_mm.x(), place.to_mm.x()) - reach_mm;
    const double last_x = std::max(place.from_mm.x(), place.to_mm.x()) + reach_mm;
    auto i = std::lower_bound(by_x.begin(), by_x.end(), first_x,
                              [&](Eigen::Index column, double x) { return points(0, column) < x; });
    for (; i != by_x.end() && points(0, *i) <= last_x; ++i) {
      const double nearness = 1 - std::pow(distance_to_segment_mm(points.col(*i), place) / reach_mm, 2);
      if (nearness > 0) smoothing[*i] = std::max(smoothing[*i], most * nearness * nearness);
    }
  }
  return smoothing;
}

bool is_explained_by(const std::vector<SoftPlace>& places, const Eigen::Vector3d& point_mm, double wrong_by_mm,
                     const SofteningOptions& options) {
  return std::any_of(places.begin(), places.end(), [&](const SoftPlace& place) {
    return std::abs(wrong_by_mm) <= place.distance_mm &&
           distance_to_segment_mm(point_mm, place) < options.reach * place.distance_mm;
  });
}

}  // namespace isostack
