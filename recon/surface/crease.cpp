#include "recon/surface/crease.h"

#include <Eigen/Eigenvalues>
#include <utility>
#include <vector>

namespace isostack {

namespace {

// Sides that turn by θ give sin²(θ/2); a round surface with edges of half its radius stays below.
constexpr double least_spread = 0.09;
// Two sides of a sharp edge are nearly parallel: there the spread says nothing, but both look away from their mean.
constexpr double least_cosine_to_mean = 0.4;

}  // namespace

Crease crease_at(const EditableMesh& mesh, int v) {
  // Weighted by the angle at v: how a side is cut into triangles makes no difference.
  std::vector<std::pair<Eigen::Vector3d, double>> sides;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  double total = 0, away = 0;
  for (const int t : mesh.triangles_at(v)) {
    const Eigen::Vector3d unit = mesh.area_normal(t).stableNormalized();
    const double angle = mesh.angle_at(t, v);
    if (unit.isZero(0)) continue;
    sides.emplace_back(unit, angle);
    normal += angle * unit;
    tensor += angle * unit * unit.transpose();
    total += angle;
  }
  normal.stableNormalize();
  for (const auto& [unit, angle] : sides)
    if (unit.dot(normal) < least_cosine_to_mean) away += angle;
  if (total <= 0) return {Freedom::plane, Eigen::Vector3d::Zero()};
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread;
  spread.computeDirect(tensor / total);
  const Eigen::Vector3d along = spread.eigenvectors().col(0);
  if (spread.eigenvalues()[0] > least_spread) return {Freedom::none, along};
  const bool is_crease = spread.eigenvalues()[1] > least_spread || away > 0.1 * total;
  return {is_crease ? Freedom::line : Freedom::plane, along};
}

}  // namespace isostack
