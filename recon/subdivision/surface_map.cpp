#include "recon/subdivision/surface_map.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/subdivision/collapse_history.h"
#include "recon/subdivision/domain_growth.h"
#include "recon/subdivision/torus_start.h"

namespace isostack {

namespace {

std::string name_of(const TriangleMesh& mesh) { return mesh.name.empty() ? "surface" : mesh.name; }

/// The four corners left of a sphere.
DomainMesh tetrahedron_start(const std::vector<Eigen::Vector3i>& triangles, std::size_t vertices) {
  DomainMesh made;
  made.positions.assign(vertices, Eigen::Vector3d::Zero());
  made.triangles = triangles;
  made.offsets.resize(triangles.size());
  for (CornerOffsets& offsets : made.offsets) offsets.fill(Eigen::Vector2i::Zero());
  const auto first = *std::find_if(triangles.begin(), triangles.end(), [](const auto& t) { return t[0] >= 0; });
  const Eigen::Vector3d corners[4] = {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}};
  for (const Eigen::Vector3i& t : triangles)
    for (const int v : t) {
      if (v < 0) continue;
      const auto at = std::find(first.begin(), first.end(), v) - first.begin();
      made.positions[static_cast<std::size_t>(v)] = corners[at].normalized();
    }
  const auto p = [&](int c) { return made.positions[static_cast<std::size_t>(first[c])]; };
  if (made.domain.orientation(p(0), p(1), p(2)) < 0)
    for (Eigen::Vector3d& position : made.positions) position = -position;
  return made;
}

}  // namespace

int genus_of(const TriangleMesh& mesh) {
  const MeshMeasures measures = measure(mesh);
  if (!measures.watertight())
    throw InputError(name_of(mesh), "the surface is not closed", "close it, or use the variational method");
  if (measures.components != 1)
    throw InputError(name_of(mesh), fmt::format("the surface is in {} parts", measures.components),
                     "morph them one by one, or use the methods variational, level-set or blend");
  return static_cast<int>(std::lround(measures.genus));
}

DomainMesh spread_over_domain(const TriangleMesh& mesh, const SurfaceMapOptions& options, const Progress& progress) {
  const int genus = genus_of(mesh);
  if (genus > 1)
    throw InputError(name_of(mesh), fmt::format("the surface has genus {}", genus),
                     "the subdivision method takes genus 0 and 1; use variational, level-set or blend");
  const CollapseHistory history = collapsed(mesh);
  DomainGrowth growth(mesh, genus == 0 ? tetrahedron_start(history.coarse, mesh.vertices_mm.size())
                                       : torus_start(history.coarse, static_cast<int>(mesh.vertices_mm.size())));
  std::size_t vertices = mesh.vertices_mm.size() - history.splits.size(), swept = vertices;
  const auto settle = [&](int sweeps) {
    for (int i = 0; i < sweeps; ++i) {
      growth.sweep();
      growth.reshape();
    }
  };
  settle(options.final_sweeps);
  for (auto split = history.splits.rbegin(); split != history.splits.rend(); ++split) {
    growth.undo(*split);
    growth.relax_round(split->gone);
    if (++vertices < swept + swept / 4 + 1) continue;
    swept = vertices;
    settle(options.sweeps);
    progress.report("spread surface", static_cast<double>(vertices) / static_cast<double>(mesh.vertices_mm.size()));
  }
  settle(options.final_sweeps);
  return growth.drawn();
}

DomainWalk::DomainWalk(const DomainMesh& drawn) : drawn_(drawn) {
  std::map<std::pair<int, int>, std::pair<int, int>> sides;  // directed edge: triangle, corner opposite
  for (int t = 0; t < static_cast<int>(drawn.triangles.size()); ++t)
    for (int c = 0; c < 3; ++c) {
      const Eigen::Vector3i& corners = drawn.triangles[static_cast<std::size_t>(t)];
      sides[{corners[(c + 1) % 3], corners[(c + 2) % 3]}] = {t, c};
    }
  std::vector<Eigen::Vector3i> beside_all(drawn.triangles.size());
  for (const auto& [edge, side] : sides)
    beside_all[static_cast<std::size_t>(side.first)][side.second] = sides.at({edge.second, edge.first}).first;
  beside_ = std::make_shared<const std::vector<Eigen::Vector3i>>(std::move(beside_all));
}

/// A walk that crosses any edge which has the point on its other side, at random where there are two, ends (Devillers,
/// Pion & Teillaud 2002). On the torus it goes over the plane that is wound round it, to one copy of the point.
SurfacePlace DomainWalk::find(const Eigen::Vector3d& point) {
  Eigen::Vector3d p = point;
  const SurfaceDomain& domain = drawn_.domain;
  if (domain.genus > 0) {  // the copy that is nearest to where it was
    const Eigen::Vector2d off = domain.periods.topRows<2>().inverse() * (p - drawn_.corner(last_, 0, 0)).head<2>();
    p -= domain.periods * Eigen::Vector2d(std::round(off.x()), std::round(off.y()));
  }
  for (std::size_t step = 0; step < 10 * drawn_.triangles.size() + 100; ++step) {
    const Eigen::Vector3d a = drawn_.corner(last_, 0, 0), b = drawn_.corner(last_, 1, 0),
                          c = drawn_.corner(last_, 2, 0);
    const Eigen::Vector3d areas(domain.orientation(p, b, c), domain.orientation(a, p, c), domain.orientation(a, b, p));
    Eigen::Index side;
    const double rounding = 1e-12 * std::abs(domain.orientation(a, b, c)) + 4e-15 * p.squaredNorm();
    if (areas.minCoeff(&side) >= -rounding) {
      const Eigen::Vector3d shares = areas.cwiseMax(0.0);
      return {last_, shares / shares.sum()};
    }
    chance_ = chance_ * 1664525u + 1013904223u;
    if (areas[(side + 1) % 3] < 0 && chance_ >> 31) side = (side + 1) % 3;
    cross(static_cast<int>(side), p);
  }
  return nearest(point);
}

/// Of all triangles the one whose smallest share is largest.
SurfacePlace DomainWalk::nearest(const Eigen::Vector3d& point) {
  const SurfaceDomain& domain = drawn_.domain;
  SurfacePlace best{0, Eigen::Vector3d::UnitX()};
  double most = -std::numeric_limits<double>::max();
  for (int t = 0; t < static_cast<int>(drawn_.triangles.size()); ++t) {
    const Eigen::Vector3d a = drawn_.corner(t, 0, 0), b = drawn_.corner(t, 1, 0), c = drawn_.corner(t, 2, 0);
    const Eigen::Vector3d p = domain.genus == 0 ? point : Eigen::Vector3d(a + domain.way(a, point));
    if (domain.genus == 0 && p.dot(a + b + c) < 0) continue;  // beyond the far side
    Eigen::Vector3d shares(domain.orientation(p, b, c), domain.orientation(a, p, c), domain.orientation(a, b, p));
    shares /= shares.cwiseAbs().sum();
    if (shares.minCoeff() <= most) continue;
    most = shares.minCoeff();
    best = {t, shares.cwiseMax(0.0) / shares.cwiseMax(0.0).sum()};
  }
  last_ = best.triangle;
  return best;
}

/// The next triangle may be drawn elsewhere: the point goes along.
void DomainWalk::cross(int side, Eigen::Vector3d& p) {
  const int shared = drawn_.triangles[static_cast<std::size_t>(last_)][(side + 1) % 3];
  const Eigen::Vector3d here = drawn_.corner(last_, (side + 1) % 3, 0);
  last_ = beside(last_, side);
  if (drawn_.domain.genus == 0) return;
  const Eigen::Vector3i& next = drawn_.triangles[static_cast<std::size_t>(last_)];
  p += drawn_.corner(last_, next[0] == shared ? 0 : next[1] == shared ? 1 : 2, 0) - here;
}

}  // namespace isostack
