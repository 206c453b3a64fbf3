#include "recon/subdivision/simplex_section.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "recon/subdivision/directed_loops.h"

namespace isostack {

namespace {

/// The edge a point of the section lies on, or twice the vertex that it is.
using EdgeEnds = std::pair<int, int>;

/// A mesh as a section sees it.
class CutMesh {
 public:
  CutMesh(const SimplicialMesh& mesh, const Eigen::VectorXd& values, OnSection on)
      : mesh_(mesh), values_(values), on_(on) {}

  bool is_after(int vertex) const { return on_ == OnSection::beyond ? values_[vertex] >= 0 : values_[vertex] > 0; }

  EdgeEnds ends(int a, int b) const { return {std::min(a, b), std::max(a, b)}; }

  /// The same for all edges that meet the section in one vertex.
  EdgeEnds point(const EdgeEnds& edge) const {
    if (values_[edge.first] == 0) return {edge.first, edge.first};
    if (values_[edge.second] == 0) return {edge.second, edge.second};
    return edge;
  }

  Eigen::VectorXd place(const EdgeEnds& edge) const {
    const auto [a, b] = edge;
    const Eigen::Index dimension = mesh_.dimension() - 1;
    if (values_[a] == 0 || a == b) return mesh_.vertices.col(a).head(dimension);
    if (values_[b] == 0) return mesh_.vertices.col(b).head(dimension);
    const double share = values_[a] / (values_[a] - values_[b]);
    return (1 - share) * mesh_.vertices.col(a).head(dimension) + share * mesh_.vertices.col(b).head(dimension);
  }

 private:
  const SimplicialMesh& mesh_;
  const Eigen::VectorXd& values_;
  OnSection on_;
};

/// From the edge where the section enters each triangle to that where it leaves it.
std::map<EdgeEnds, EdgeEnds> segments(const SimplicialMesh& mesh, const CutMesh& cut) {
  std::map<EdgeEnds, EdgeEnds> next;
  for (Eigen::Index s = 0; s < mesh.simplex_count(); ++s) {
    const Eigen::Vector3i corners = mesh.simplices.col(s);
    for (int i = 0; i < 3; ++i) {
      const int alone = corners[i], second = corners[(i + 1) % 3], third = corners[(i + 2) % 3];
      if (cut.is_after(alone) == cut.is_after(second) || cut.is_after(alone) == cut.is_after(third)) continue;
      const EdgeEnds to_second = cut.ends(alone, second), to_third = cut.ends(alone, third);
      if (cut.is_after(alone))
        next.emplace(to_second, to_third);
      else
        next.emplace(to_third, to_second);
    }
  }
  return next;
}

/// The four corners evenly permuted, so that those before the section come first.
std::array<int, 4> before_first(const Eigen::Vector4i& corners, const std::array<bool, 4>& after, int before_count) {
  static constexpr std::array<std::array<std::size_t, 4>, 8> even = {
      {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}}};
  for (const auto& order : even) {
    bool sorted = true;
    for (std::size_t i = 0; i < 4; ++i) sorted &= after[order[i]] == (static_cast<int>(i) >= before_count);
    if (sorted)
      return {corners[static_cast<Eigen::Index>(order[0])], corners[static_cast<Eigen::Index>(order[1])],
              corners[static_cast<Eigen::Index>(order[2])], corners[static_cast<Eigen::Index>(order[3])]};
  }
  return {corners[0], corners[1], corners[2], corners[3]};
}

/// Corners of the polygon in which the section cuts a tetrahedron, counter-clockwise seen from outside.
std::vector<EdgeEnds> polygon(const Eigen::Vector4i& corners, const CutMesh& cut) {
  std::array<bool, 4> after{};
  int before_count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    after[i] = cut.is_after(corners[static_cast<Eigen::Index>(i)]);
    before_count += after[i] ? 0 : 1;
  }
  if (before_count == 0 || before_count == 4) return {};
  if (before_count == 3) {  // the last is alone: seen from the other side
    for (bool& side : after) side = !side;
    const auto [d, a, b, c] = before_first(corners, after, 1);
    return {cut.ends(d, a), cut.ends(d, c), cut.ends(d, b)};
  }
  const auto [a, b, c, d] = before_first(corners, after, before_count);
  if (before_count == 1) return {cut.ends(a, b), cut.ends(a, c), cut.ends(a, d)};
  return {cut.ends(a, c), cut.ends(a, d), cut.ends(b, d), cut.ends(b, c)};
}

}  // namespace

std::vector<Contour> section_contours(const SimplicialMesh& mesh, const Eigen::VectorXd& values, OnSection on) {
  const CutMesh cut(mesh, values, on);
  std::map<EdgeEnds, EdgeEnds> next = segments(mesh, cut);
  std::vector<Contour> contours;
  while (!next.empty()) {
    Contour contour;
    EdgeEnds last = {-1, -1}, first = {-1, -1};
    for (auto at = next.begin(); at != next.end();) {
      const EdgeEnds edge = at->first, following = at->second;
      next.erase(at);
      if (cut.point(edge) != last) contour.points_mm.emplace_back(cut.place(edge));
      if (first.first < 0) first = cut.point(edge);
      last = cut.point(edge);
      at = next.find(following);
    }
    if (contour.points_mm.size() > 1 && first == last) contour.points_mm.pop_back();
    if (contour.points_mm.size() >= 3) contours.push_back(std::move(contour));
  }
  return figure_of(std::move(contours));
}

TriangleMesh section_mesh(const SimplicialMesh& mesh, const Eigen::VectorXd& values, OnSection on) {
  const CutMesh cut(mesh, values, on);
  TriangleMesh result;
  std::map<EdgeEnds, int> numbers;
  const auto number = [&](const EdgeEnds& edge) {
    const auto [at, is_new] = numbers.try_emplace(cut.point(edge), static_cast<int>(result.vertices_mm.size()));
    if (is_new) result.vertices_mm.emplace_back(cut.place(edge));
    return at->second;
  };
  const auto add = [&](int a, int b, int c) {
    if (a != b && b != c && a != c) result.triangles.emplace_back(a, b, c);
  };
  for (Eigen::Index s = 0; s < mesh.simplex_count(); ++s) {
    std::vector<int> corners;
    for (const EdgeEnds& edge : polygon(mesh.simplices.col(s), cut)) corners.push_back(number(edge));
    if (corners.size() >= 3) add(corners[0], corners[1], corners[2]);
    if (corners.size() == 4) add(corners[0], corners[2], corners[3]);
  }
  return result;
}

Eigen::VectorXd values_at_time(const SimplicialMesh& mesh, double t_mm) {
  return mesh.vertices.row(mesh.dimension() - 1).transpose().array() - t_mm;
}

}  // namespace isostack
