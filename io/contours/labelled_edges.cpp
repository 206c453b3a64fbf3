#include "io/contours/labelled_edges.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <set>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// An edge of one label, which lies to its left.
struct DirectedEdge {
  int from = 0, to = 0;
  bool used = false;
};

/// For every vertex the first one at its place.
std::vector<int> first_at_place(const std::vector<Eigen::Vector3d>& vertices) {
  std::map<std::array<double, 3>, int> first;
  std::vector<int> result;
  for (const Eigen::Vector3d& v : vertices)
    result.push_back(first.try_emplace({v.x(), v.y(), v.z()}, static_cast<int>(result.size())).first->second);
  return result;
}

/// Walks along the edges of one label.
class LoopWalk {
 public:
  LoopWalk(const SectionPlane& plane, std::vector<DirectedEdge> edges)
      : plane_(plane), normal_(plane.equation.head<3>()), edges_(std::move(edges)) {
    for (std::size_t i = 0; i < edges_.size(); ++i) leaving_[edges_[i].from].push_back(i);
  }

  std::vector<SectionLoop> loops(int label) {
    std::vector<SectionLoop> result;
    for (std::size_t start = 0; start < edges_.size(); ++start) {
      if (edges_[start].used) continue;
      SectionLoop& loop = result.emplace_back(SectionLoop{.label = label, .vertices = {}});
      std::size_t edge = start;
      do {
        edges_[edge].used = true;
        loop.vertices.push_back(edges_[edge].from);
        edge = next(edge, start, label);
      } while (edge != start);
    }
    return result;
  }

 private:
  Eigen::Vector3d along(int from, int to) const {
    return plane_.vertices_mm[static_cast<std::size_t>(to)] - plane_.vertices_mm[static_cast<std::size_t>(from)];
  }

  /// The first way on clockwise from the way back: nothing of the label lies between the two.
  std::size_t next(std::size_t edge, std::size_t start, int label) const {
    const DirectedEdge& here = edges_[edge];
    const Eigen::Vector3d back = along(here.to, here.from), left = normal_.cross(back);
    const double scale = normal_.norm();
    double best = 0;
    std::size_t result = edges_.size();
    if (const auto found = leaving_.find(here.to); found != leaving_.end())
      for (const std::size_t candidate : found->second) {
        if (edges_[candidate].used && candidate != start) continue;
        const Eigen::Vector3d way = along(here.to, edges_[candidate].to);
        double clockwise = -std::atan2(way.dot(left), scale * way.dot(back));
        if (clockwise <= 0) clockwise += 2 * std::numbers::pi;
        if (result < edges_.size() && clockwise >= best) continue;
        best = clockwise;
        result = candidate;
      }
    if (result == edges_.size())
      throw InputError(plane_.where, fmt::format("the boundary of label {} ends at vertex {}", label, here.to),
                       "boundaries must be closed curves; repair the edges");
    return result;
  }

  const SectionPlane& plane_;
  Eigen::Vector3d normal_;
  std::vector<DirectedEdge> edges_;
  std::map<int, std::vector<std::size_t>> leaving_;
};

}  // namespace

std::vector<SectionLoop> loops_of_labels(const SectionPlane& plane, const std::vector<LabelledEdge>& edges,
                                         int outside_label) {
  const std::vector<int> place = first_at_place(plane.vertices_mm);
  std::map<int, std::vector<DirectedEdge>> edges_of;
  for (const LabelledEdge& edge : edges) {
    const int from = place[static_cast<std::size_t>(edge.from)], to = place[static_cast<std::size_t>(edge.to)];
    if (edge.left == edge.right || from == to) continue;
    if (edge.left != outside_label) edges_of[edge.left].push_back({from, to});
    if (edge.right != outside_label) edges_of[edge.right].push_back({to, from});
  }
  std::vector<SectionLoop> loops;
  for (const auto& [label, of_label] : edges_of)
    for (SectionLoop& loop : LoopWalk(plane, of_label).loops(label)) loops.push_back(std::move(loop));
  return loops;
}

}  // namespace isostack
