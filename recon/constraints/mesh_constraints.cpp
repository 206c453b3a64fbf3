#include "recon/constraints/mesh_constraints.h"

#include <oneapi/tbb/parallel_for.h>

#include <array>
#include <optional>

#include "recon/metrics/closest_point.h"

namespace isostack {

namespace {

struct Partner {
  Eigen::Vector3d point_mm;
  double distance_mm;
};

/// Along the normal, at doubled distances up to the offset, as long as nothing of the mesh is much nearer than the
/// sample it went out from: so another sheet in between cannot be passed.
std::optional<Partner> place_partner(const ClosestPoint& surface, const MeshSample& sample, double offset_mm) {
  std::optional<Partner> best;
  for (int halvings = 4; halvings >= 0; --halvings) {
    const double step_mm = offset_mm / (1 << halvings);
    const Eigen::Vector3d point = sample.point_mm + step_mm * sample.outward;
    const double distance_mm = (surface.on_mesh(point) - point).norm();
    if (distance_mm < 0.7 * step_mm) break;
    best = Partner{point, distance_mm};
  }
  return best;
}

}  // namespace

ConstraintSet mesh_constraints(const TriangleMesh& mesh, const std::vector<MeshSample>& samples,
                               const MeshConstraintOptions& options) {
  using Partners = std::array<std::optional<Partner>, 2>;  // inside, outside
  std::vector<Partners> partners(samples.size());
  const ClosestPoint surface(mesh);
  tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
    const MeshSample inward{samples[i].point_mm, -samples[i].outward};
    if (options.as_in_paper)
      partners[i][0] = Partner{inward.point_mm + options.offset_mm * inward.outward, 1};
    else
      partners[i] = {place_partner(surface, inward, options.offset_mm),
                     place_partner(surface, samples[i], options.offset_mm)};
  });
  std::vector<Eigen::Vector3d> points;
  std::vector<double> values(samples.size(), 0.0);
  for (const MeshSample& sample : samples) points.push_back(sample.point_mm);
  for (const Partners& both : partners)
    for (std::size_t side = 0; side < 2; ++side)
      if (both[side]) {
        points.push_back(both[side]->point_mm);
        values.push_back(side == 0 ? both[side]->distance_mm : -both[side]->distance_mm);
      }
  const auto count = static_cast<Eigen::Index>(points.size());
  return {Eigen::Map<const Eigen::MatrixXd>(points.empty() ? nullptr : points.front().data(), 3, count),
          Eigen::Map<const Eigen::VectorXd>(values.data(), count),
          {}};
}

}  // namespace isostack
