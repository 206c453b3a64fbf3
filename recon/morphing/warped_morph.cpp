#include <algorithm>
#include <memory>
#include <utility>

#include "recon/morphing/warp.h"

namespace isostack {

namespace {

/// The spacetime function F ∘ u and what belongs to it.
SpacetimeField displaced_back(SpacetimeField inner, const std::shared_ptr<const HalfwayWarp>& warp) {
  const double length_mm = inner.bounds_mm.max().z() - inner.bounds_mm.min().z();
  const double first_mm = inner.bounds_mm.min().z();
  const auto time = [=](double z_mm) { return std::clamp((z_mm - first_mm) / length_mm, 0.0, 1.0); };
  const auto there = [=](const Eigen::Vector3d& point) -> Eigen::Vector3d {
    const Eigen::Vector2d place = warp->displaced(point.head<2>(), time(point.z()));
    return {place.x(), place.y(), point.z()};
  };
  const ScalarField field = inner.field;
  const auto all_there = [=](const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3Xd moved(3, points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) moved.col(i) = there(points.col(i));
    return moved;
  };
  SpacetimeField result = std::move(inner);
  result.field.values = [=](const Eigen::Matrix3Xd& points) { return field.values(all_there(points)); };
  result.field.gradients = [=](const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3Xd gradients = field.gradients(all_there(points));
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const double t = time(points(2, i));
      const Eigen::Vector2d place = points.col(i).head<2>(), inner_slope = gradients.col(i).head<2>();
      gradients.col(i).head<2>() = warp->jacobians(place, t).front().transpose() * inner_slope;
      gradients(2, i) += inner_slope.dot(warp->velocity(place, t).col(0)) / length_mm;
    }
    return gradients;
  };
  for (Eigen::Vector3d& seed : result.seeds_mm) {
    seed.head<2>() = warp->undisplaced(seed.head<2>(), time(seed.z())).col(0);
    result.bounds_mm.extend(seed);
  }
  return result;
}

class WarpedMorph : public MorphMethod {
 public:
  WarpedMorph(Morph inner, HalfwayWarp warp)
      : inner_(std::move(inner)), warp_(std::make_shared<const HalfwayWarp>(std::move(warp))) {}

  std::vector<Shape> shapes_at(const std::vector<Eigen::VectorXd>& weights, const Progress& progress) const override {
    std::vector<Shape> shapes = inner_.frames(weights, progress);
    for (std::size_t i = 0; i < shapes.size(); ++i)  // of two shapes, the second's weight is the time
      shapes[i] = warp_->undisplaced(std::move(shapes[i]), std::clamp(weights[i][1], 0.0, 1.0));
    return shapes;
  }

  std::optional<SpacetimeField> spacetime() const override {
    std::optional<SpacetimeField> inner = inner_.spacetime();
    if (!inner) return std::nullopt;
    return displaced_back(*std::move(inner), warp_);
  }

 private:
  Morph inner_;
  std::shared_ptr<const HalfwayWarp> warp_;
};

}  // namespace

Morph warped_morph(const std::vector<KeyShape>& shapes, const std::vector<LandmarkPair>& landmarks,
                   const std::function<Morph(const std::vector<KeyShape>&)>& make_morph) {
  HalfwayWarp warp(shapes, landmarks);
  Morph inner = make_morph(warp.displaced_shapes());
  MorphReport report = inner.report();
  report.landmarks = landmarks.size();
  const KeyPlaces places = inner.places();
  return Morph(std::make_shared<const WarpedMorph>(std::move(inner), std::move(warp)), places, std::move(report));
}

}  // namespace isostack
