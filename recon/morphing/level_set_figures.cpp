#include <algorithm>
#include <utility>

#include "recon/geometry/pixel_lattice.h"
#include "recon/morphing/figure_frames.h"
#include "recon/morphing/lattice_leg.h"
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

class FigureLeg : public LatticeLeg<2> {
 public:
  FigureLeg(LegShapes shapes, const FigureFrames& frames, Field<2> start, Field<2> target)
      : LatticeLeg(std::move(shapes), std::move(start), std::move(target)), frames_(frames) {}

 private:
  Eigen::Vector3d place_in_target(const Position& node) const override {
    const PlaneLattice& lattice = frames_.lattice();
    const Eigen::Vector2d place = lattice.first_mm + lattice.spacing_mm * Eigen::Vector2d(node[0], node[1]);
    return frames_.pose().slice_to_world(transform().moved(place, 1));
  }
  double cell_content() const override { return frames_.lattice().spacing_mm * frames_.lattice().spacing_mm; }
  Shape shape_of(const Field<2>& phi, const Progress& /*progress*/) const override {
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

  FigureFrames frames_;
};

}  // namespace

std::shared_ptr<LevelSetLeg> figure_leg(LegShapes shapes) {
  const KeyShape target = shapes.target();
  const FigureFrames frames({shapes.from, target}, shapes.options.resolution_mm);
  Field<2> start = distances_at_nodes(shapes.from, frames.lattice());
  return std::make_shared<FigureLeg>(std::move(shapes), frames, std::move(start),
                                     distances_at_nodes(target, frames.lattice()));
}

}  // namespace isostack
