#include "recon/constraints/surface_lean.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "recon/solvers/box_tree.h"

namespace isostack {

Eigen::VectorXd smoothed_lean(const Eigen::Matrix3Xd& gradients, const Eigen::Matrix3Xd& points_mm,
                              const Eigen::Matrix3Xd& plane_normals, double radius_mm) {
  const std::vector<std::uint32_t> order = curve_order(points_mm);
  Eigen::MatrixXd points(3, points_mm.cols());
  Eigen::Matrix3Xd normals(3, points_mm.cols());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    points.col(at) = points_mm.col(order[k]);
    normals.col(at) = gradients.col(order[k]).stableNormalized();
  }
  const BoxTree tree(std::move(points));
  Eigen::VectorXd lean(normals.cols());
  tbb::parallel_for(Eigen::Index{0}, normals.cols(), [&](Eigen::Index i) {
    std::vector<BoxTree::Neighbour> neighbours;
    tree.within(tree.points().col(i), radius_mm, neighbours, [](std::uint32_t) { return true; });
    std::sort(neighbours.begin(), neighbours.end());  // sums in one order, whatever the tree's
    const auto sample = order[static_cast<std::size_t>(i)];
    double sum = 0, weights = 0;
    for (const BoxTree::Neighbour& neighbour : neighbours) {
      const double nearness = 1 - neighbour.squared_distance / (radius_mm * radius_mm);
      const double weight = nearness * std::max(0.0, normals.col(neighbour.index).dot(normals.col(i)));
      sum += weight * normals.col(neighbour.index).dot(plane_normals.col(sample));
      weights += weight;
    }
    lean[sample] = weights > 0 ? sum / weights : 0;
  });
  return lean;
}

}  // namespace isostack
