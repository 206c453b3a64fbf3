#include "recon/morphing/blend_sections.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "recon/geometry/pixel_lattice.h"
#include "recon/metrics/contour_distance.h"
#include "recon/morphing/figure_frames.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/surface_seeds.h"

namespace isostack {

namespace {

/// Of any solid: blends have kinks, where there is no gradient.
Eigen::Matrix3Xd central_differences(const SolidFunction& solid, const Eigen::Matrix3Xd& points, double step_mm) {
  Eigen::Matrix3Xd result(3, points.cols());
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d offset = step_mm * Eigen::Vector3d::Unit(axis);
    result.row(axis) = (solid(points.colwise() + offset) - solid(points.colwise() - offset)) / (2 * step_mm);
  }
  return result;
}

ScalarField field_of(SolidFunction solid, double step_mm) {
  ScalarField field;
  field.values = [solid](const Eigen::Matrix3Xd& points) -> Eigen::VectorXd { return solid(points); };
  field.gradients = [solid = std::move(solid), step_mm](const Eigen::Matrix3Xd& points) {
    return central_differences(solid, points, step_mm);
  };
  return field;
}

constexpr double gradient_step = 1e-3;  // of the resolution

/// Frames of figures and of bodies, as sections at times.
class BlendSections : public MorphMethod {
 public:
  explicit BlendSections(BlendedMorph morph) : morph_(std::move(morph)), box_mm_(box_of(morph_.shapes)) {
    if (dimension_of(morph_.shapes.front().shape) == 2) figures_.emplace(morph_.shapes, morph_.resolution_mm);
  }

  std::vector<Shape> shapes_at(const std::vector<Eigen::VectorXd>& weights, const Progress& progress) const override {
    std::vector<Shape> shapes;
    for (const Eigen::VectorXd& weight : weights) {
      progress.report("frames", static_cast<double>(shapes.size()) / static_cast<double>(weights.size()));
      shapes.push_back(shape_at(weight, progress));
    }
    return shapes;
  }

  std::optional<SpacetimeField> spacetime() const override {
    if (!figures_) return std::nullopt;
    SpacetimeField result;
    result.field =
        field_of([pairs = morph_.pairs, times_mm = key_times_mm(), length_mm = morph_.length_mm](
                     const Eigen::MatrixXd& points) { return values_between(pairs, times_mm, length_mm, points); },
                 gradient_step * morph_.resolution_mm);
    const Eigen::AlignedBox2d box = widened(figures_->box_mm(), 0.5);
    result.bounds_mm.min() << box.min(), key_times_mm().minCoeff();
    result.bounds_mm.max() << box.max(), key_times_mm().maxCoeff();
    for (std::size_t i = 0; i < morph_.shapes.size(); ++i)
      for (const Eigen::Vector2d& point : points_along(in_frame(i).contours, morph_.resolution_mm))
        result.seeds_mm.emplace_back(point.x(), point.y(), key_times_mm()[static_cast<Eigen::Index>(i)]);
    return result;
  }

 private:
  Eigen::RowVectorXd key_times_mm() const { return morph_.length_mm * morph_.places.coordinates.row(0); }

  /// Each pair's own time runs evenly from one key shape to the next, whatever their times are.
  static Eigen::ArrayXd values_between(const std::vector<BlendedPair>& pairs, const Eigen::RowVectorXd& times_mm,
                                       double length_mm, const Eigen::MatrixXd& points) {
    Eigen::ArrayXd values(points.cols());
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
      const auto n = static_cast<Eigen::Index>(pair);
      std::vector<Eigen::Index> here;
      for (Eigen::Index i = 0; i < points.cols(); ++i)
        if ((n == 0 || points(2, i) >= times_mm[n]) && (pair + 1 == pairs.size() || points(2, i) < times_mm[n + 1]))
          here.push_back(i);
      if (here.empty()) continue;
      Eigen::MatrixXd own = points(Eigen::all, here);
      own.row(2) = (own.row(2).array() - times_mm[n]) * (length_mm / (times_mm[n + 1] - times_mm[n]));
      values(here) = pairs[pair].space_time(own);
    }
    return values;
  }

  Shape shape_at(const Eigen::VectorXd& weights, const Progress& progress) const {
    const Eigen::RowVectorXd times = morph_.places.coordinates.row(0);
    const double time = morph_.places.place_at(weights)[0];
    Eigen::Index pair = 0;
    while (pair + 2 < times.size() && time >= times[pair + 1]) ++pair;
    const auto n = static_cast<std::size_t>(pair);
    const double own_mm = morph_.length_mm * (time - times[pair]) / (times[pair + 1] - times[pair]);
    const TimeSpan& changing = morph_.pairs[n].changing_mm;
    const double rounding_mm = 1e-12 * morph_.length_mm;
    if (own_mm <= changing.from + rounding_mm) return key(n);
    if (own_mm >= changing.to - rounding_mm) return key(n + 1);
    const SolidFunction section = cross_section(morph_.pairs[n].space_time, own_mm);
    if (!figures_) return body(section, progress);
    return figures_->trace([&](const Eigen::Matrix2Xd& points) -> Eigen::VectorXd { return section(points); });
  }

  Shape key(std::size_t i) const { return figures_ ? Shape(in_frame(i)) : morph_.shapes[i].shape; }

  ContourSlice in_frame(std::size_t i) const {
    ContourSlice figure = std::get<ContourSlice>(morph_.shapes[i].shape);
    figure.contours = moved_to(figures_->pose(), figure.contours, figure.pose);
    figure.pose = figures_->pose();
    return figure;
  }

  TriangleMesh body(const SolidFunction& section, const Progress& progress) const {
    const double side_mm = box_mm_.sizes().maxCoeff();
    const auto widened_by = [&](double by_mm) {
      return Eigen::AlignedBox3d(box_mm_.min().array() - by_mm, box_mm_.max().array() + by_mm);
    };
    const ScalarField field = field_of(section, gradient_step * morph_.resolution_mm);
    const double looked_at_mm = std::max(2 * morph_.resolution_mm, side_mm / most_looks);
    const std::vector<Eigen::Vector3d> seeds = surface_seeds(field, widened_by(seeded_margin * side_mm), looked_at_mm);
    if (seeds.empty()) return {};
    ExtractionOptions options;
    options.resolution_mm = morph_.resolution_mm;
    options.bounds = widened_by(followed_margin * side_mm);
    options.may_be_empty = true;  // what is smaller than a cell is lost
    return extract_surface(field, seeds, options, {.on_report = {}, .is_cancelled = progress.is_cancelled}).mesh;
  }

  // Added material may reach beyond the key shapes.
  static constexpr double seeded_margin = 0.25, followed_margin = 0.75;
  static constexpr double most_looks = 96;

  BlendedMorph morph_;
  Eigen::AlignedBox3d box_mm_;
  std::optional<FigureFrames> figures_;  ///< none: bodies
};

}  // namespace

std::shared_ptr<const MorphMethod> blend_sections(BlendedMorph morph) {
  return std::make_shared<const BlendSections>(std::move(morph));
}

}  // namespace isostack
