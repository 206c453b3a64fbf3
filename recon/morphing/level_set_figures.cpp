#include <algorithm>
#include <utility>

#include "recon/geometry/pixel_lattice.h"
#include "recon/morphing/figure_frames.h"
#include "recon/morphing/level_set_leg.h"
#include "recon/morphing/level_set_run.h"
#include "recon/morphing/signed_distance_stack.h"

namespace isostack {

namespace {

/// Exact at the nodes, mm. The figure is in the lattice's coordinates.
Field<2> distances_at_nodes(const KeyShape& figure, const PlaneLattice& lattice) {
  const SlicePose plane;  // slice coordinates are world coordinates there
  SlicePose nodes = plane;
  nodes.origin_mm.head<2>() = lattice.first_mm;
  nodes.spacing_mm.setConstant(lattice.spacing_mm);
  const auto& contours = std::get<ContourSlice>(figure.shape).contours;
  return field_of(signed_distance_image(contours, plane, {nodes, lattice.size}), nodes.spacing_mm);
}

/// Linear along both axes between nodes; outside the lattice its rim's value.
double value_between(const Field<2>& field, const Eigen::Vector2d& at_node) {
  std::array<int, 2> low{};
  Eigen::Vector2d share;
  for (int axis = 0; axis < 2; ++axis) {
    const int last = field.size[static_cast<std::size_t>(axis)] - 1;
    const double at = std::clamp(at_node[axis], 0.0, static_cast<double>(last));
    low[static_cast<std::size_t>(axis)] = std::min(static_cast<int>(at), last - 1);
    share[axis] = at - low[static_cast<std::size_t>(axis)];
  }
  const auto along_x = [&](int row) {
    const double left = field.values[field.node_at({low[0], row})];
    return left + share.x() * (static_cast<double>(field.values[field.node_at({low[0] + 1, row})]) - left);
  };
  return (1 - share.y()) * along_x(low[1]) + share.y() * along_x(low[1] + 1);
}

class FigureLeg : public LevelSetLeg {
 public:
  FigureLeg(LegShapes shapes, const KeyShape& target)
      : shapes_(std::move(shapes)),
        frames_({shapes_.from, target}, shapes_.options.resolution_mm),
        run_(distances_at_nodes(shapes_.from, frames_.lattice()), distances_at_nodes(target, frames_.lattice())) {}

  bool overlaps() const override { return run_.overlaps(); }

  std::vector<UnsharedPart> unshared() const override {
    std::vector<UnsharedPart> parts;
    const double pixel_mm2 = frames_.lattice().spacing_mm * frames_.lattice().spacing_mm;
    for (const UnsharedRegion& region : run_.unshared()) {
      const auto node = run_.target().position_of(region.deepest);
      const Eigen::Vector2d place =
          frames_.lattice().first_mm + frames_.lattice().spacing_mm * Eigen::Vector2d(node[0], node[1]);
      parts.push_back({.from = shapes_.from.name,
                       .to = shapes_.to.name,
                       .is_hollow = !region.is_inside,
                       .place_mm = frames_.pose().slice_to_world(shapes_.transform.moved(place, 1)),
                       .content = pixel_mm2 * static_cast<double>(region.nodes.size())});
    }
    return parts;
  }

  void seed_unshared() override { run_.seed_unshared(); }
  void run(const Progress& progress) override { run_.run(shapes_.options, progress); }

  LevelSetCourse course() const override {
    LevelSetCourse course = run_.course();
    course.from = shapes_.from.name;
    course.to = shapes_.to.name;
    return course;
  }

  std::vector<Shape> shapes_at(const std::vector<double>& shares, const Progress& progress) const override {
    std::vector<Shape> shapes(shares.size());
    run_.fields_at(shares, progress, [&](std::size_t i, const Field<2>& phi) {
      shapes[i] = shapes_.transform.moved(Shape(traced(phi)), shares[i]);
    });
    return shapes;
  }

 private:
  ContourSlice traced(const Field<2>& phi) const {
    const PlaneLattice& lattice = frames_.lattice();
    const PlaneFunction function = [&](const Eigen::Matrix2Xd& points) {
      Eigen::VectorXd values(points.cols());
      for (Eigen::Index i = 0; i < points.cols(); ++i)
        values[i] = value_between(phi, (points.col(i) - lattice.first_mm) / lattice.spacing_mm);
      return values;
    };
    const Eigen::Map<const Eigen::VectorXf> nodes(phi.values.data(), static_cast<Eigen::Index>(phi.values.size()));
    return frames_.trace(function, nodes.cast<double>());
  }

  LegShapes shapes_;
  FigureFrames frames_;
  LevelSetRun<2> run_;
};

}  // namespace

std::shared_ptr<LevelSetLeg> figure_leg(LegShapes shapes) {
  const KeyShape target = shapes.target();
  return std::make_shared<FigureLeg>(std::move(shapes), target);
}

}  // namespace isostack
