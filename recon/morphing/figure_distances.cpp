#include <oneapi/tbb/parallel_for.h>

#include <utility>

#include "recon/geometry/pixel_lattice.h"
#include "recon/metrics/contour_distance.h"
#include "recon/morphing/distance_sections.h"
#include "recon/morphing/figure_frames.h"
#include "recon/morphing/signed_distance_stack.h"

namespace isostack {

namespace {

/// Exact signed distance to one figure, in the frames' slice coordinates.
class FigureDistance {
 public:
  explicit FigureDistance(std::vector<Contour> contours) : contours_(std::move(contours)), distance_(contours_) {}

  double at(const Eigen::Vector2d& point) const {
    const double mm = distance_.to(point);
    return is_inside(contours_, point) ? mm : -mm;
  }

  Eigen::VectorXd at_nodes(const PlaneLattice& lattice) const {
    const SlicePose plane;  // slice coordinates are world coordinates there
    SlicePose nodes = plane;
    nodes.origin_mm.head<2>() = lattice.first_mm;
    nodes.spacing_mm.setConstant(lattice.spacing_mm);
    const Image<float> image = signed_distance_image(contours_, plane, {nodes, lattice.size});
    return Eigen::Map<const Eigen::VectorXf>(image.data(), image.size()).cast<double>();
  }

 private:
  std::vector<Contour> contours_;
  ContourDistance distance_;
};

class FigureDistances : public MorphMethod {
 public:
  explicit FigureDistances(DistanceMorph morph)
      : morph_(std::move(morph)), frames_(morph_.shapes, morph_.resolution_mm) {
    for (const KeyShape& shape : morph_.shapes) {
      const auto& figure = std::get<ContourSlice>(shape.shape);
      distances_.push_back(std::make_shared<FigureDistance>(moved_to(frames_.pose(), figure.contours, figure.pose)));
      at_nodes_.push_back(distances_.back()->at_nodes(frames_.lattice()));
      boundaries_.push_back(points_along(moved_to(frames_.pose(), figure.contours, figure.pose), morph_.resolution_mm));
    }
  }

  std::vector<Shape> shapes_at(const std::vector<Eigen::VectorXd>& weights, const Progress& progress) const override {
    std::vector<Shape> shapes;
    for (const Eigen::VectorXd& place : weights) {
      progress.report("frames", static_cast<double>(shapes.size()) / static_cast<double>(weights.size()));
      const Eigen::VectorXd shares = morph_.weights.at(place);
      Eigen::VectorXd nodes = Eigen::VectorXd::Zero(at_nodes_.front().size());
      for (std::size_t i = 0; i < at_nodes_.size(); ++i) nodes += shares[static_cast<Eigen::Index>(i)] * at_nodes_[i];
      const PlaneFunction mean = [&](const Eigen::Matrix2Xd& points) {
        return over_points(points.cols(), [&](Eigen::Index p) { return mixed(points.col(p), shares); });
      };
      shapes.emplace_back(frames_.trace(mean, nodes));
    }
    return shapes;
  }

  std::optional<SpacetimeField> spacetime() const override {
    if (morph_.weights.places().layout != KeyLayout::line) return std::nullopt;
    const Eigen::RowVectorXd times_mm = morph_.spacing_mm * morph_.weights.places().coordinates.row(0);
    SpacetimeField result;
    result.field.values = [self = *this](const Eigen::Matrix3Xd& points) { return self.values(points); };
    result.field.gradients = [self = *this](const Eigen::Matrix3Xd& points) { return self.gradients(points); };
    const Eigen::AlignedBox2d box = widened(frames_.box_mm(), 0.1);
    result.bounds_mm.min() << box.min(), times_mm.minCoeff();
    result.bounds_mm.max() << box.max(), times_mm.maxCoeff();
    for (std::size_t i = 0; i < boundaries_.size(); ++i)
      for (const Eigen::Vector2d& point : boundaries_[i])
        result.seeds_mm.emplace_back(point.x(), point.y(), times_mm[static_cast<Eigen::Index>(i)]);
    return result;
  }

 private:
  template <class ValueAt>
  static Eigen::VectorXd over_points(Eigen::Index count, ValueAt value_at) {
    Eigen::VectorXd values(count);
    tbb::parallel_for(Eigen::Index{0}, count, [&](Eigen::Index i) { values[i] = value_at(i); });
    return values;
  }

  double mixed(const Eigen::Vector2d& point, const Eigen::VectorXd& shares) const {
    double sum = 0;
    for (std::size_t i = 0; i < distances_.size(); ++i)
      if (const double share = shares[static_cast<Eigen::Index>(i)]; share != 0)
        sum += share * distances_[i]->at(point);
    return sum;
  }

  Eigen::VectorXd values(const Eigen::Matrix3Xd& points) const {
    return over_points(points.cols(), [&](Eigen::Index i) {
      return mixed(points.col(i).head<2>(), morph_.weights.along(points(2, i) / morph_.spacing_mm));
    });
  }

  /// Central differences: distances have kinks, where there is no gradient.
  Eigen::Matrix3Xd gradients(const Eigen::Matrix3Xd& points) const {
    const double step = 1e-3 * morph_.resolution_mm;
    Eigen::Matrix3Xd result(3, points.cols());
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d offset = step * Eigen::Vector3d::Unit(axis);
      result.row(axis) = (values(points.colwise() + offset) - values(points.colwise() - offset)) / (2 * step);
    }
    return result;
  }

  DistanceMorph morph_;
  FigureFrames frames_;
  std::vector<std::shared_ptr<const FigureDistance>> distances_;  ///< one for each key shape
  std::vector<Eigen::VectorXd> at_nodes_;                         ///< of the frames' lattice
  std::vector<std::vector<Eigen::Vector2d>> boundaries_;
};

}  // namespace

std::shared_ptr<const MorphMethod> figure_distances(DistanceMorph morph) {
  return std::make_shared<const FigureDistances>(std::move(morph));
}

}  // namespace isostack
