#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/geometry/volume.h"
#include "recon/metrics/closest_point.h"
#include "recon/metrics/voxelize.h"
#include "recon/morphing/distance_sections.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/surface_seeds.h"
#include "recon/surface/trilinear_field.h"

namespace isostack {

namespace {

constexpr double margin_cells = 3;

Grid grid_round(const std::vector<KeyShape>& bodies, double spacing_mm) {
  const Eigen::AlignedBox3d box = box_of(bodies);
  Grid grid;
  grid.size = ((box.sizes() / spacing_mm).array().ceil() + 2 * margin_cells + 1).cast<int>();
  grid.index_to_world.linear() *= spacing_mm;
  grid.index_to_world.translation() = box.center() - 0.5 * spacing_mm * (grid.size.array() - 1).matrix().cast<double>();
  return grid;
}

/// Exact at the nodes, mm, positive inside.
Volume<float> signed_distances(const TriangleMesh& body, const Grid& grid) {
  LabelVolume inside(grid);
  voxelize(body, 1, inside);
  const ClosestPoint closest(body);
  Volume<float> distances(grid);
  tbb::parallel_for(0, grid.size.z(), [&](int k) {
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Vector3d node = grid.index_to_world * Eigen::Vector3d(i, j, k);
        const double mm = (closest.on_mesh(node) - node).norm();
        distances.at(i, j, k) = static_cast<float>(inside.at(i, j, k) != 0 ? mm : -mm);
      }
  });
  return distances;
}

class BodyDistances : public MorphMethod {
 public:
  BodyDistances(DistanceMorph morph, const Grid& grid, const Progress& progress) : morph_(std::move(morph)) {
    for (const KeyShape& shape : morph_.shapes) {
      progress.report("distances", static_cast<double>(nodes_.size()) / static_cast<double>(morph_.shapes.size()));
      nodes_.push_back(signed_distances(std::get<TriangleMesh>(shape.shape), grid));
    }
  }

  std::vector<Shape> shapes_at(const std::vector<Eigen::VectorXd>& weights, const Progress& progress) const override {
    std::vector<Shape> shapes;
    for (const Eigen::VectorXd& place : weights) {
      progress.report("frames", static_cast<double>(shapes.size()) / static_cast<double>(weights.size()));
      shapes.emplace_back(body(mixed(morph_.weights.at(place)), progress));
    }
    return shapes;
  }

 private:
  Volume<float> mixed(const Eigen::VectorXd& shares) const {
    Volume<float> sum(nodes_.front().grid);
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      const auto share = static_cast<float>(shares[static_cast<Eigen::Index>(s)]);
      if (share == 0) continue;
      std::transform(sum.voxels.begin(), sum.voxels.end(), nodes_[s].voxels.begin(), sum.voxels.begin(),
                     [share](float total, float value) { return total + share * value; });
    }
    return sum;
  }

  TriangleMesh body(Volume<float> nodes, const Progress& progress) const {
    const Grid grid = nodes.grid;
    ExtractionOptions options;
    options.resolution_mm = morph_.resolution_mm;
    options.bounds = Eigen::AlignedBox3d(grid.index_to_world * Eigen::Vector3d::Zero(),
                                         grid.index_to_world * (grid.size.array() - 1).matrix().cast<double>());
    const ScalarField field = trilinear_field(std::make_shared<const Volume<float>>(std::move(nodes)));
    const std::vector<Eigen::Vector3d> seeds = surface_seeds(field, options.bounds, morph_.resolution_mm);
    if (seeds.empty()) return {};
    return extract_surface(field, seeds, options, {.on_report = {}, .is_cancelled = progress.is_cancelled}).mesh;
  }

  DistanceMorph morph_;
  std::vector<Volume<float>> nodes_;  ///< signed distances to each key shape
};

void require_grids(const DistanceMorph& morph, std::size_t limit_bytes) {
  const Eigen::Array3d cells = box_of(morph.shapes).sizes().array() / morph.resolution_mm + 2 * margin_cells + 2;
  const double bytes = cells.prod() * (sizeof(float) * static_cast<double>(morph.shapes.size() + 1) + 2);
  if (!(bytes <= static_cast<double>(limit_bytes)))
    throw SolveError(
        "morph", fmt::format("its grids of distances at {:.3g} mm take {:.3g} GB", morph.resolution_mm, bytes * 1e-9),
        "give a coarser resolution, or allow more memory");
}

}  // namespace

std::shared_ptr<const MorphMethod> body_distances(DistanceMorph morph, std::size_t memory_limit_bytes,
                                                  const Progress& progress) {
  require_grids(morph, memory_limit_bytes);
  const Grid grid = grid_round(morph.shapes, morph.resolution_mm);
  return std::make_shared<const BodyDistances>(std::move(morph), grid, progress);
}

}  // namespace isostack
