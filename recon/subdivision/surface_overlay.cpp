#include "recon/subdivision/surface_overlay.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "recon/subdivision/surface_map.h"

namespace isostack {

namespace {

std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

using Node = SurfaceOverlay::Node;

class OverlayMaker {
 public:
  OverlayMaker(const TriangleMesh& surface, const DomainMesh& drawn, const DomainMesh& mesh)
      : surface_(surface), drawn_(drawn), mesh_(mesh), walk_(mesh), around_(mesh.positions.size()) {
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
      for (const int v : mesh.triangles[index(t)]) around_[index(v)].push_back(t);
  }

  SurfaceOverlay run() {
    locate_vertices();
    for (int t = 0; t < static_cast<int>(drawn_.triangles.size()); ++t)
      for (int c = 0; c < 3; ++c) {
        const int u = drawn_.triangles[index(t)][c], v = drawn_.triangles[index(t)][(c + 1) % 3];
        if (u < v) trace(u, v, drawn_.corner(t, (c + 1) % 3, c) - drawn_.corner(t, c, c));
      }
    order_edges();
    return std::move(made_);
  }

 private:
  /// Where a surface's vertex is: within a triangle as an added node, or a vertex of the mesh.
  struct Home {
    int triangle = -1, mesh_vertex = -1;
    int added = -1;
  };

  /// A way over the mesh along one edge of the surface, in the frame in which the current triangle is drawn.
  struct Way {
    int u, v;
    Eigen::Vector3d from, to;
    std::vector<std::pair<int, std::array<Node, 2>>> pieces;
    std::vector<std::pair<std::array<int, 2>, SurfaceOverlay::Added>> crossings;
  };

  void locate_vertices() {
    homes_.resize(surface_.vertices_mm.size());
    std::vector<char> used(homes_.size(), 0);
    for (const Eigen::Vector3i& t : surface_.triangles)
      for (const int v : t) used[index(v)] = 1;
    for (std::size_t v = 0; v < homes_.size(); ++v) {
      if (!used[v]) continue;
      const SurfacePlace at = walk_.find(drawn_.positions[v]);
      Eigen::Index corner;
      if (at.shares.maxCoeff(&corner) > 1 - 1e-9) {
        homes_[v].mesh_vertex = mesh_.triangles[index(at.triangle)][corner];
        made_.met[homes_[v].mesh_vertex] = surface_.vertices_mm[v];
        continue;
      }
      homes_[v].triangle = at.triangle;
      homes_[v].added = static_cast<int>(made_.added.size());
      made_.inside[at.triangle].push_back(homes_[v].added);
      made_.added.push_back({surface_.vertices_mm[v], at.shares});
    }
  }

  Node node_of(int v) const {
    const Home& home = homes_[index(v)];
    return home.added >= 0 ? Node{true, home.added} : Node{false, home.mesh_vertex};
  }
  int number_in(int triangle, int vertex) const {
    const Eigen::Vector3i& t = mesh_.triangles[index(triangle)];
    return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
  }
  Eigen::Vector3d corner(int triangle, int number) const { return mesh_.corner(triangle, number, 0); }

  /// On which side of the way a corner lies: 1 left, −1 right, 0 on it.
  int side(const Way& way, const Eigen::Vector3d& p) const {
    const double area = SurfaceDomain::orientation(way.from, way.to, p);
    const double least = 1e-10 * (way.to - way.from).norm() * ((p - way.from).norm() + (way.to - way.from).norm());
    return area > least ? 1 : area < -least ? -1 : 0;
  }
  bool is_ahead(const Way& way, const Eigen::Vector3d& here, const Eigen::Vector3d& p) const {
    return (p - here).dot(way.to - way.from) > 0;
  }

  void enter(Way& way, int from_triangle, int to_triangle, int shared) const {
    if (mesh_.domain.genus == 0) return;
    const Eigen::Vector3d shift =
        corner(to_triangle, number_in(to_triangle, shared)) - corner(from_triangle, number_in(from_triangle, shared));
    way.from += shift;
    way.to += shift;
  }

  /// Where the way leaves the triangle: across the side that has its first corner on the right and its second on the
  /// left, or through a corner ahead.
  struct Exit {
    int side = -1, corner = -1;
  };
  Exit exit_of(const Way& way, int triangle, int entered_side, int entered_corner) const {
    std::array<int, 3> sides{};
    for (int c = 0; c < 3; ++c) sides[index(c)] = c == entered_corner ? 0 : side(way, corner(triangle, c));
    const Eigen::Vector3d here = entered_corner >= 0 ? corner(triangle, entered_corner) : way.from;
    for (int c = 0; c < 3; ++c)
      if (c != entered_corner && sides[index(c)] == 0 && is_ahead(way, here, corner(triangle, c)) &&
          (entered_side < 0 || c == (entered_side + 2) % 3))
        return {-1, c};
    for (int c = 0; c < 3; ++c)
      if (c != entered_side && sides[index(c)] < 0 && sides[index((c + 1) % 3)] > 0) return {c, -1};
    return {};
  }

  /// False when the way is lost.
  bool cross(Way& way, int triangle, int at_side, Node& last) {
    const Eigen::Vector3d a = corner(triangle, at_side), b = corner(triangle, (at_side + 1) % 3);
    const double right = std::abs(SurfaceDomain::orientation(way.from, way.to, a));
    const double left = std::abs(SurfaceDomain::orientation(way.from, way.to, b));
    const double behind = SurfaceDomain::orientation(a, b, way.from), ahead = -SurfaceDomain::orientation(a, b, way.to);
    if (!(behind > 0) || !(ahead > 0) || !(right + left > 0)) return false;
    const Eigen::Vector3i& t = mesh_.triangles[index(triangle)];
    const int from = t[at_side], to = t[(at_side + 1) % 3];
    const double share_of_to = right / (right + left), share_of_v = behind / (behind + ahead);
    const Eigen::Vector3d place =
        (1 - share_of_v) * surface_.vertices_mm[index(way.u)] + share_of_v * surface_.vertices_mm[index(way.v)];
    const Node crossing{true, static_cast<int>(made_.added.size() + way.crossings.size())};
    way.crossings.emplace_back(std::array{std::min(from, to), std::max(from, to)},
                               SurfaceOverlay::Added{place, {from < to ? share_of_to : 1 - share_of_to, 0, 0}});
    way.pieces.emplace_back(triangle, std::array{last, crossing});
    last = crossing;
    return true;
  }

  /// From a vertex of the mesh: the triangle round it that the way goes into, and whether it goes along an edge.
  std::optional<std::pair<int, Exit>> leave_vertex(Way& way, int triangle, int vertex) const {
    for (const int next : around_[index(vertex)]) {
      Way moved{way.u, way.v, way.from, way.to, {}, {}};
      enter(moved, triangle, next, vertex);
      const int own = number_in(next, vertex);
      const Eigen::Vector3d here = corner(next, own);
      const int first = side(moved, corner(next, (own + 1) % 3)), second = side(moved, corner(next, (own + 2) % 3));
      const bool along = first == 0 && is_ahead(moved, here, corner(next, (own + 1) % 3));
      if (!along && !(first < 0 && second > 0)) continue;
      way.from = moved.from;
      way.to = moved.to;
      return std::pair(next, along ? Exit{-1, (own + 1) % 3} : Exit{(own + 1) % 3, -1});
    }
    return std::nullopt;
  }

  void trace(int u, int v, const Eigen::Vector3d& step) {
    const Home &start = homes_[index(u)], &goal = homes_[index(v)];
    Way way{u, v, drawn_.positions[index(u)], drawn_.positions[index(v)], {}, {}};
    int triangle = start.triangle >= 0 ? start.triangle : around_[index(start.mesh_vertex)].front();
    if (mesh_.domain.genus > 0) {
      way.from.setZero();
      if (start.triangle >= 0)
        for (int c = 0; c < 3; ++c) way.from += made_.added[index(start.added)].shares[c] * corner(triangle, c);
      else
        way.from = corner(triangle, number_in(triangle, start.mesh_vertex));
      way.to = way.from + step;
    }
    Node last = node_of(u);
    int entered_side = -1, at_vertex = start.mesh_vertex;
    for (std::size_t steps = 0; steps < mesh_.triangles.size(); ++steps) {
      Exit exit;
      if (at_vertex >= 0) {
        if (at_vertex == goal.mesh_vertex) return keep(way);
        const auto left = leave_vertex(way, triangle, at_vertex);
        if (!left) return;
        triangle = left->first;
        exit = left->second;
      }
      if (triangle == goal.triangle && exit.corner < 0) {
        way.pieces.emplace_back(triangle, std::array{last, node_of(v)});
        return keep(way);
      }
      if (at_vertex < 0) exit = exit_of(way, triangle, entered_side, -1);
      at_vertex = -1;
      if (exit.corner >= 0) {
        at_vertex = mesh_.triangles[index(triangle)][exit.corner];
        way.pieces.emplace_back(triangle, std::array{last, Node{false, at_vertex}});
        last = {false, at_vertex};
        continue;
      }
      if (exit.side < 0 || !cross(way, triangle, exit.side, last)) return;
      const int shared = mesh_.triangles[index(triangle)][exit.side];
      const int next = walk_.beside(triangle, (exit.side + 2) % 3);
      enter(way, triangle, next, shared);
      triangle = next;
      entered_side = (number_in(next, shared) + 2) % 3;
    }
  }

  void keep(const Way& way) {
    for (const auto& [edge, crossing] : way.crossings) {
      made_.on_edge[edge].push_back(static_cast<int>(made_.added.size()));
      made_.added.push_back(crossing);
    }
    for (const auto& [triangle, nodes] : way.pieces) made_.pieces[triangle].push_back(nodes);
  }

  /// Strictly ascending shares, seen from both sides alike.
  void order_edges() {
    for (auto& [edge, nodes] : made_.on_edge) {
      const auto share = [&](int node) -> double& { return made_.added[index(node)].shares[0]; };
      std::stable_sort(nodes.begin(), nodes.end(), [&](int a, int b) { return share(a) < share(b); });
      const double least = 1e-6 / static_cast<double>(nodes.size());
      double before = 0;
      for (const int node : nodes) before = share(node) = std::max(share(node), before + least);
      double after = 1;
      for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
        after = share(*node) = std::min(share(*node), after - least);
    }
  }

  const TriangleMesh& surface_;
  const DomainMesh &drawn_, &mesh_;
  DomainWalk walk_;
  std::vector<std::vector<int>> around_;
  std::vector<Home> homes_;
  SurfaceOverlay made_;
};

}  // namespace

SurfaceOverlay surface_overlay(const TriangleMesh& surface, const DomainMesh& drawn, const DomainMesh& mesh) {
  return OverlayMaker(surface, drawn, mesh).run();
}

}  // namespace isostack
