#include "recon/subdivision/base_tetrahedra.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/subdivision/base_mesh.h"

namespace isostack {

namespace {

/// An edge of a mesh (its left triangle to the left of from → to) and its dual, right to left.
struct DualEdge {
  int from, to;
  Eigen::Vector3d right, left;
};

/// Nearest copy of q to p.
Eigen::Vector3d copy_near(const SurfaceDomain& domain, const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  if (domain.genus == 0) return q;
  const Eigen::Vector2d off = domain.periods.topRows<2>().inverse() * (q - p).head<2>();
  Eigen::Vector3d best = q;
  double nearest = std::numeric_limits<double>::max();
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) {
      const Eigen::Vector3d copy =
          q - domain.periods * Eigen::Vector2d(std::round(off.x()) + i, std::round(off.y()) + j);
      if ((copy - p).norm() >= nearest) continue;
      nearest = (copy - p).norm();
      best = copy;
    }
  return best;
}

/// The dual graph as drawn, moved a little: equal meshes' dual graphs would lie on each other.
struct DualGraph {
  std::vector<Eigen::Vector3d> cells;     ///< of each vertex: its middle
  std::vector<Eigen::Vector3d> vertices;  ///< one for each triangle
  std::vector<DualEdge> edges;
};

DualGraph dual_graph(const DomainMesh& base, double moved) {
  const Eigen::Vector3d axis = Eigen::Vector3d(0.36, -0.48, 0.8);
  const auto shifted = [&](const Eigen::Vector3d& p) {
    return base.domain.genus == 0 ? Eigen::Vector3d(Eigen::AngleAxisd(moved, axis) * p)
                                  : Eigen::Vector3d(p + moved * Eigen::Vector3d(0.8, 0.37, 0));
  };
  DualGraph made;
  for (const Eigen::Vector3d& p : base.positions) made.cells.push_back(shifted(p));
  for (const Eigen::Vector3d& p : dual_points(base)) made.vertices.push_back(shifted(p));
  std::map<std::pair<int, int>, std::size_t> left_of;
  for (std::size_t t = 0; t < base.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c) left_of[{base.triangles[t][c], base.triangles[t][(c + 1) % 3]}] = t;
  for (const auto& [edge, left] : left_of) {
    if (edge.first > edge.second) continue;
    const Eigen::Vector3d right = made.vertices[left_of.at({edge.second, edge.first})];
    made.edges.push_back({edge.first, edge.second, right, copy_near(base.domain, right, made.vertices[left])});
  }
  return made;
}

int cell_of(const SurfaceDomain& domain, const std::vector<Eigen::Vector3d>& cells, const Eigen::Vector3d& p) {
  const auto distance = [&](const Eigen::Vector3d& cell) { return (copy_near(domain, p, cell) - p).norm(); };
  return static_cast<int>(std::min_element(cells.begin(), cells.end(),
                                           [&](const auto& a, const auto& b) { return distance(a) < distance(b); }) -
                          cells.begin());
}

/// 1 where second's dual crosses first's from its right to its left, −1 the other way, 0 where they do not cross.
int crossing(const SurfaceDomain& domain, const DualEdge& first, const DualEdge& second) {
  const Eigen::Vector3d &a = first.right, &b = first.left;
  const Eigen::Vector3d middle = copy_near(domain, (a + b) / 2, (second.right + second.left) / 2);
  const Eigen::Vector3d shift = middle - (second.right + second.left) / 2;
  const Eigen::Vector3d c = second.right + shift, d = second.left + shift;
  if (domain.genus == 0 && (a + b).dot(c + d) < 0) return 0;  // the far sides of their great circles
  const bool c_left = SurfaceDomain::orientation(a, b, c) > 0, d_left = SurfaceDomain::orientation(a, b, d) > 0;
  const bool a_left = SurfaceDomain::orientation(c, d, a) > 0, b_left = SurfaceDomain::orientation(c, d, b) > 0;
  if (c_left == d_left || a_left == b_left) return 0;
  return d_left ? 1 : -1;
}

/// Every triangle belongs to two tetrahedra that see it from both sides, or is one of the two meshes' (once).
bool is_bounded_by(const std::vector<Eigen::Vector4i>& tetrahedra, const DomainMesh& first, const DomainMesh& second) {
  std::map<std::array<int, 3>, std::pair<int, int>> sides;  // sorted corners: count, sum of orientations
  const auto add = [&](std::array<int, 3> corners, int sign) {
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)}) {
      auto &p = corners[static_cast<std::size_t>(i)], &q = corners[static_cast<std::size_t>(j)];
      if (p <= q) continue;
      std::swap(p, q);
      sign = -sign;
    }
    auto& [count, sum] = sides[corners];
    ++count;
    sum += sign;
  };
  for (const Eigen::Vector4i& t : tetrahedra) {
    add({t[1], t[2], t[3]}, 1);
    add({t[0], t[2], t[3]}, -1);
    add({t[0], t[1], t[3]}, 1);
    add({t[0], t[1], t[2]}, -1);
  }
  const int offset = static_cast<int>(first.positions.size());
  for (const Eigen::Vector3i& t : first.triangles) add({t[0], t[1], t[2]}, 1);
  for (const Eigen::Vector3i& t : second.triangles) add({offset + t[0], offset + t[1], offset + t[2]}, -1);
  return std::all_of(sides.begin(), sides.end(),
                     [](const auto& side) { return side.second.first == 2 && side.second.second == 0; });
}

std::vector<Eigen::Vector4i> overlay(const DomainMesh& first, const DomainMesh& second, double moved) {
  const SurfaceDomain& domain = first.domain;
  const DualGraph lower = dual_graph(first, 0), upper = dual_graph(second, moved);
  const int offset = static_cast<int>(first.positions.size());
  std::vector<Eigen::Vector4i> made;
  for (std::size_t t = 0; t < second.triangles.size(); ++t) {  // rule (a)
    const Eigen::Vector3i corners = second.triangles[t].array() + offset;
    made.emplace_back(cell_of(domain, lower.cells, upper.vertices[t]), corners[0], corners[1], corners[2]);
  }
  for (const DualEdge& low : lower.edges)  // rule (b)
    for (const DualEdge& high : upper.edges) {
      const int sign = crossing(domain, low, high);
      if (sign < 0) made.emplace_back(low.from, low.to, offset + high.from, offset + high.to);
      if (sign > 0) made.emplace_back(low.from, low.to, offset + high.to, offset + high.from);
    }
  for (std::size_t t = 0; t < first.triangles.size(); ++t) {  // rule (c)
    const Eigen::Vector3i& corners = first.triangles[t];
    made.emplace_back(corners[0], corners[1], corners[2], offset + cell_of(domain, upper.cells, lower.vertices[t]));
  }
  return made;
}

}  // namespace

Eigen::MatrixXi base_tetrahedra(const DomainMesh& first, const DomainMesh& second) {
  for (const double moved : {1e-3, 1.7e-3, 2.9e-3, 5.3e-3, 1.1e-2}) {
    const std::vector<Eigen::Vector4i> found = overlay(first, second, moved);
    if (!is_bounded_by(found, first, second)) continue;
    Eigen::MatrixXi made(4, static_cast<Eigen::Index>(found.size()));
    for (std::size_t t = 0; t < found.size(); ++t) made.col(static_cast<Eigen::Index>(t)) = found[t];
    return made;
  }
  throw GeometryError("base meshes", "no tetrahedra could be found between them", "ask for other feature points");
}

}  // namespace isostack
