#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "recon/distance/mesh_distance.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/volume.h"
#include "recon/morphing/lattice_leg.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/trilinear_field.h"
#include "segmentation/lattice.h"

namespace isostack {

namespace {

constexpr double margin_cells = 3;
constexpr double bytes_per_node = 40;  // two distances, φ, where it was, its band, what a frame takes

Grid grid_round(const std::vector<KeyShape>& bodies, double spacing_mm, std::size_t limit_bytes) {
  const Eigen::AlignedBox3d box = box_of(bodies);
  const Eigen::Array3d cells = (box.sizes().array() / spacing_mm).ceil() + 2 * margin_cells + 1;
  if (!(bytes_per_node * cells.prod() <= static_cast<double>(limit_bytes)))
    throw SolveError(
        "morph",
        fmt::format("its nodes, {:.3g} mm apart, take {:.3g} GB", spacing_mm, 1e-9 * bytes_per_node * cells.prod()),
        "give a coarser resolution, or allow more memory");
  Grid grid;
  grid.size = cells.cast<int>();
  grid.index_to_world.linear() *= spacing_mm;
  grid.index_to_world.translation() = box.center() - 0.5 * spacing_mm * (grid.size.array() - 1).matrix().cast<double>();
  return grid;
}

Field<3> distances_at_nodes(const KeyShape& body, const Grid& grid, const Progress& progress) {
  Volume<float> distances = mesh_distance(std::get<TriangleMesh>(body.shape), grid, {}, progress).distance_mm;
  const double spacing_mm = grid.index_to_world.linear()(0, 0);
  return {
      {grid.size.x(), grid.size.y(), grid.size.z()}, {spacing_mm, spacing_mm, spacing_mm}, std::move(distances.voxels)};
}

/// Where φ is 0 on the lattice's edges: on every part of the surface, however small.
std::vector<Eigen::Vector3d> crossings(const Field<3>& phi, const Grid& grid) {
  const Lattice<3> lattice(phi);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t node = 0; node < phi.values.size(); ++node) {
    if (phi.values[node] < 0) continue;
    const auto at = phi.position_of(node);
    lattice.for_each_neighbour(lattice.sides_of(node), [&](int axis, std::ptrdiff_t step) {
      const double here = phi.values[node], there = phi.values[lattice.moved(node, step)];
      if (there >= 0) return;
      Eigen::Vector3d index(at[0], at[1], at[2]);
      index[axis] += (step > 0 ? 1 : -1) * here / (here - there);
      points.push_back(grid.index_to_world * index);
    });
  }
  return points;
}

TriangleMesh surface_of(const Field<3>& phi, const Grid& grid, const Progress& progress) {
  const std::vector<Eigen::Vector3d> seeds = crossings(phi, grid);
  if (seeds.empty()) return {};
  auto volume = std::make_shared<Volume<float>>();
  volume->grid = grid;
  volume->voxels = phi.values;
  ExtractionOptions options;
  options.resolution_mm = grid.index_to_world.linear()(0, 0);
  options.bounds = Eigen::AlignedBox3d(grid.index_to_world * Eigen::Vector3d::Zero(),
                                       grid.index_to_world * (grid.size.array() - 1).matrix().cast<double>());
  options.may_be_empty = true;
  return extract_surface(trilinear_field(std::move(volume)), seeds, options,
                         {.on_report = {}, .is_cancelled = progress.is_cancelled})
      .mesh;
}

class BodyLeg : public LatticeLeg<3> {
 public:
  BodyLeg(LegShapes shapes, const Grid& grid, Field<3> start, Field<3> target)
      : LatticeLeg(std::move(shapes), std::move(start), std::move(target)), grid_(grid) {}

 private:
  Eigen::Vector3d place_in_target(const Position& node) const override {
    return transform().moved((grid_.index_to_world * Eigen::Vector3d(node[0], node[1], node[2])).eval(), 1);
  }
  double cell_content() const override { return grid_.voxel_volume_mm3(); }
  Shape shape_of(const Field<3>& phi, const Progress& progress) const override {
    return surface_of(phi, grid_, progress);
  }

  Grid grid_;
};

}  // namespace

std::shared_ptr<LevelSetLeg> body_leg(LegShapes shapes, const Progress& progress) {
  const KeyShape target = shapes.target();
  const Grid grid = grid_round({shapes.from, target}, shapes.options.resolution_mm, shapes.options.memory_limit_bytes);
  Field<3> start = distances_at_nodes(shapes.from, grid, progress);
  return std::make_shared<BodyLeg>(std::move(shapes), grid, std::move(start),
                                   distances_at_nodes(target, grid, progress));
}

}  // namespace isostack
