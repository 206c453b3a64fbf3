#include "recon/subdivision/domain_features.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "recon/geometry/errors.h"
#include "recon/subdivision/domain_growth.h"

namespace isostack {

namespace {

double size_of(const SurfaceDomain& domain) {
  return domain.genus == 0 ? 1.2 : std::min(domain.periods.col(0).norm(), domain.periods.col(1).norm()) / 3;
}

/// All vertices near p go along with it, the less the farther; the radius is at least five steps, so that nothing is
/// overtaken.
std::vector<Eigen::Vector3d> carried(const DomainMesh& drawn, const Eigen::Vector3d& p, const Eigen::Vector3d& step,
                                     double radius) {
  std::vector<Eigen::Vector3d> moved = drawn.positions;
  for (Eigen::Vector3d& q : moved) {
    const double r = drawn.domain.way(p, q).norm() / radius;
    if (r < 1) q = drawn.domain.onto(q + (1 - r * r) * (1 - r * r) * step);
  }
  return moved;
}

/// As it is near p.
Eigen::Vector3d target_copy(const SurfaceDomain& domain, const Eigen::Vector3d& p, const PulledVertex& vertex) {
  return domain.genus == 0 ? vertex.target : Eigen::Vector3d(p + domain.way(p, vertex.target));
}

/// The way to the target, or, where another corner is near and ahead, past that on the side where it is not.
Eigen::Vector3d way_past(const SurfaceDomain& domain, const Eigen::Vector3d& p, const Eigen::Vector3d& target,
                         const Eigen::Vector3d& other) {
  Eigen::Vector3d way = domain.way(p, target);
  const Eigen::Vector3d to_other = domain.way(p, other);
  const double near = 0.4 * size_of(domain);
  if (way.norm() < to_other.norm() || to_other.norm() > near || way.dot(to_other) < 0.4 * way.norm() * to_other.norm())
    return way;
  const Eigen::Vector3d up = domain.genus == 0 ? p : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d left = up.cross(to_other).normalized() * to_other.norm();
  return left.dot(way) < 0 ? Eigen::Vector3d(-left) : left;
}

/// One step towards its target. Others that are in the way are pushed aside, to come back later. False where triangles
/// would turn over.
bool pull_one(DomainGrowth& growth, const std::vector<PulledVertex>& vertices, std::size_t which) {
  const DomainMesh drawn = growth.drawn();
  const Eigen::Vector3d p = growth.position(vertices[which].vertex);
  const Eigen::Vector3d straight = drawn.domain.way(p, vertices[which].target);
  if (straight.norm() == 0) return true;
  Eigen::Vector3d way = straight;
  double radius = size_of(drawn.domain);
  const double least_radius = radius / 6;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i == which) continue;
    const Eigen::Vector3d& other = growth.position(vertices[i].vertex);
    const double distance = 0.9 * drawn.domain.distance(p, other);
    if (distance >= radius) continue;
    radius = distance;
    way = way_past(drawn.domain, p, vertices[which].target, other);
  }
  radius = std::max(radius, least_radius);
  for (double share = std::min(1.0, radius / 5 / way.norm()); share > 1e-4; share /= 2) {
    std::vector<Eigen::Vector3d> moved = carried(drawn, p, share * way, radius);
    if (share == 1 && way == straight)
      moved[static_cast<std::size_t>(vertices[which].vertex)] = target_copy(drawn.domain, p, vertices[which]);
    if (growth.displace(std::move(moved))) return true;
  }
  return false;
}

}  // namespace

DomainMesh pulled(const TriangleMesh& surface, const DomainMesh& drawn, const std::vector<PulledVertex>& vertices) {
  if (vertices.empty()) return drawn;
  DomainGrowth growth(surface, drawn);
  for (const PulledVertex& one : vertices) growth.pin(one.vertex);
  const auto is_there = [&](const PulledVertex& one) {
    return drawn.domain.way(growth.position(one.vertex), one.target).norm() < 1e-12;
  };
  constexpr int most_rounds = 400;
  for (int round = 0; !std::all_of(vertices.begin(), vertices.end(), is_there); ++round) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (round == most_rounds || !pull_one(growth, vertices, i))
        throw InputError(surface.name.empty() ? "surface" : surface.name,
                         "its feature points cannot be brought past each other to those of the shape before",
                         "name fewer pairs, or pairs that lie alike");
    growth.sweep();
  }
  for (int i = 0; i < 10; ++i) growth.sweep();
  return growth.drawn();
}

}  // namespace isostack
