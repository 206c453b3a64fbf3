#include "recon/surface/editable_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"

namespace isostack {

namespace {

bool has_corner(const Eigen::Vector3i& t, int v) { return t[0] == v || t[1] == v || t[2] == v; }

int corner_after(const Eigen::Vector3i& t, int v) { return t[0] == v ? t[1] : t[1] == v ? t[2] : t[0]; }

void require_manifold(const TriangleMesh& mesh) {
  const MeshMeasures measures = measure(mesh);
  const auto repeats = std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [](const Eigen::Vector3i& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
  if (measures.non_manifold_edges + measures.flipped_edges + static_cast<std::size_t>(repeats) == 0) return;
  throw GeometryError(mesh.name.empty() ? "surface" : mesh.name,
                      fmt::format("{} edges have more than two triangles, {} have two that disagree about the outside, "
                                  "{} triangles repeat a corner",
                                  measures.non_manifold_edges, measures.flipped_edges, repeats),
                      "repair the mesh before it is simplified or remeshed");
}

}  // namespace

EditableMesh::EditableMesh(const TriangleMesh& mesh)
    : positions_(mesh.vertices_mm),
      triangles_(mesh.triangles),
      around_(mesh.vertices_mm.size()),
      fixed_(mesh.vertices_mm.size(), false),
      triangle_count_(mesh.triangles.size()) {
  require_manifold(mesh);
  shell_.name = mesh.name;
  shell_.color = mesh.color;
  for (int t = 0; t < triangle_slots(); ++t)
    for (const int v : triangle(t)) around_[at(v)].push_back(t);
  find_fixed();
}

/// Every triangle at an ordinary vertex is reached from the first by walking round it.
void EditableMesh::find_fixed() {
  for (int v = 0; v < vertex_slots(); ++v) {
    if (!has_vertex(v)) continue;
    const int first = corner_after(triangle(around_[at(v)].front()), v);
    std::size_t steps = 0;
    int next = first;
    do {
      const Sides edge = sides(v, next);
      next = edge.is_border() ? -1 : edge.opposite[0];
      ++steps;
    } while (next >= 0 && next != first);
    fixed_[at(v)] = next < 0 || steps != around_[at(v)].size();
  }
}

TriangleMesh EditableMesh::compact() const {
  TriangleMesh mesh = shell_;
  std::vector<int> number(positions_.size(), -1);
  for (int v = 0; v < vertex_slots(); ++v) {
    if (!has_vertex(v)) continue;
    number[at(v)] = static_cast<int>(mesh.vertices_mm.size());
    mesh.vertices_mm.push_back(position(v));
  }
  for (const Eigen::Vector3i& t : triangles_)
    if (t[0] >= 0) mesh.triangles.emplace_back(number[at(t[0])], number[at(t[1])], number[at(t[2])]);
  return mesh;
}

std::vector<int> EditableMesh::neighbours(int v) const {
  std::vector<int> found;
  found.reserve(2 * around_[at(v)].size());
  for (const int t : around_[at(v)])
    for (const int corner : triangle(t))
      if (corner != v && std::find(found.begin(), found.end(), corner) == found.end()) found.push_back(corner);
  return found;
}

bool EditableMesh::are_neighbours(int a, int b) const {
  return std::any_of(around_[at(a)].begin(), around_[at(a)].end(), [&](int t) { return has_corner(triangle(t), b); });
}

EditableMesh::Sides EditableMesh::sides(int a, int b) const {
  Sides found;
  for (const int t : around_[at(a)]) {
    const Eigen::Vector3i& corners = triangle(t);
    if (!has_corner(corners, b)) continue;
    const std::size_t side = corner_after(corners, a) == b ? 0 : 1;
    found.triangles[side] = t;
    found.opposite[side] = corners.sum() - a - b;
  }
  return found;
}

Eigen::Vector3d EditableMesh::area_normal(int t) const {
  const Eigen::Vector3i& corners = triangle(t);
  const Eigen::Vector3d& a = position(corners[0]);
  return (position(corners[1]) - a).cross(position(corners[2]) - a);
}

double EditableMesh::angle_at(int t, int v) const {
  const int b = corner_after(triangle(t), v), c = corner_after(triangle(t), b);
  const Eigen::Vector3d to_b = position(b) - position(v), to_c = position(c) - position(v);
  return std::atan2(to_b.cross(to_c).norm(), to_b.dot(to_c));
}

Eigen::Vector3d EditableMesh::vertex_normal(int v) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int t : around_[at(v)]) sum += area_normal(t);
  return sum.stableNormalized();
}

bool EditableMesh::is_sliver(int t) const {
  const Eigen::Vector3i& c = triangle(t);
  const double longest = std::max({length(c[0], c[1]), length(c[1], c[2]), length(c[2], c[0])});
  return area_normal(t).norm() < 0.02 * longest * longest;
}

bool EditableMesh::keeps_directions(int v, const Eigen::Vector3d& there, double least_cosine, int except) const {
  return std::all_of(around_[at(v)].begin(), around_[at(v)].end(), [&](int t) {
    if (except >= 0 && has_corner(triangle(t), except)) return true;
    const int b = corner_after(triangle(t), v);
    const Eigen::Vector3d to_b = position(b) - there, to_c = position(corner_after(triangle(t), b)) - there;
    const Eigen::Vector3d after = to_b.cross(to_c);
    const auto agrees_with = [&](const Eigen::Vector3d& before) {
      return before.dot(after) >= least_cosine * before.norm() * after.norm();
    };
    // Triangles without area may not come about; a sliver's direction means nothing and may become its neighbours'.
    return after.squaredNorm() > 1e-24 * to_b.squaredNorm() * to_c.squaredNorm() &&
           (agrees_with(area_normal(t)) || (is_sliver(t) && agrees_with(vertex_normal(v))));
  });
}

void EditableMesh::replace_corner(int t, int from, int to) {
  for (int& corner : triangles_[at(t)])
    if (corner == from) corner = to;
}

void EditableMesh::leave(int v, int t) {
  auto& list = around_[at(v)];
  list.erase(std::find(list.begin(), list.end(), t));
}

int EditableMesh::split(int a, int b) {
  const Sides edge = sides(a, b);
  const int middle = vertex_slots();
  positions_.emplace_back((position(a) + position(b)) / 2);
  around_.emplace_back();
  fixed_.push_back(false);
  for (std::size_t side = 0; side < 2; ++side) {
    const int old = edge.triangles[side], half = triangle_slots();
    triangles_.push_back(triangle(old));
    replace_corner(half, a, middle);
    replace_corner(old, b, middle);
    leave(b, old);
    around_[at(b)].push_back(half);
    around_[at(edge.opposite[side])].push_back(half);
    around_[at(middle)].push_back(old);
    around_[at(middle)].push_back(half);
    ++triangle_count_;
  }
  return middle;
}

bool EditableMesh::may_collapse(int keep, int gone) const {
  if (is_fixed(gone)) return false;
  const Sides edge = sides(keep, gone);
  if (edge.is_border()) return false;
  // Corners opposite the edge lose a triangle; an inner vertex with two left would be a fold.
  for (const int corner : edge.opposite)
    if (around_[at(corner)].size() <= (is_fixed(corner) ? 1u : 3u)) return false;
  if ((is_fixed(edge.opposite[0]) || is_fixed(edge.opposite[1])) && are_neighbours(edge.opposite[0], edge.opposite[1]))
    return false;
  const std::vector<int> near_keep = neighbours(keep), near_gone = neighbours(gone);
  return std::count_if(near_gone.begin(), near_gone.end(),
                       [&](int v) { return std::find(near_keep.begin(), near_keep.end(), v) != near_keep.end(); }) == 2;
}

void EditableMesh::collapse(int keep, int gone, const Eigen::Vector3d& there) {
  const Sides edge = sides(keep, gone);
  for (std::size_t side = 0; side < 2; ++side) {
    leave(keep, edge.triangles[side]);
    leave(edge.opposite[side], edge.triangles[side]);
    leave(gone, edge.triangles[side]);
    triangles_[at(edge.triangles[side])].setConstant(-1);
    --triangle_count_;
  }
  for (const int t : around_[at(gone)]) {
    replace_corner(t, gone, keep);
    around_[at(keep)].push_back(t);
  }
  around_[at(gone)].clear();
  if (!is_fixed(keep)) move(keep, there);
}

bool EditableMesh::may_flip(int a, int b) const {
  const Sides edge = sides(a, b);
  if (edge.is_border() || edge.opposite[0] == edge.opposite[1]) return false;
  for (const int corner : {a, b})
    if (around_[at(corner)].size() <= (is_fixed(corner) ? 1u : 3u)) return false;
  return !are_neighbours(edge.opposite[0], edge.opposite[1]);
}

void EditableMesh::flip(int a, int b) {
  const Sides edge = sides(a, b);
  const auto [left, right] = edge.triangles;
  const auto [c, d] = edge.opposite;
  triangles_[at(left)] = {c, a, d};
  triangles_[at(right)] = {d, b, c};
  leave(b, left);
  leave(a, right);
  around_[at(d)].push_back(left);
  around_[at(c)].push_back(right);
}

}  // namespace isostack
