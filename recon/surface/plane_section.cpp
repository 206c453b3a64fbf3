#include "recon/surface/plane_section.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace isostack {

namespace {

using Edge = std::pair<int, int>;  ///< vertices, the smaller first

Edge edge_between(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Where a section runs on from an edge of the mesh, and whether it was already followed.
struct Step {
  Edge next;
  bool used = false;
};

using Steps = std::map<Edge, Step>;

/// Each triangle cut by the plane leads from one of its edges to another, the inside (its back) to the left.
Steps steps_through(const TriangleMesh& mesh, const std::vector<double>& height_mm) {
  Steps steps;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    bool above[3];
    for (int c = 0; c < 3; ++c) above[c] = height_mm[static_cast<std::size_t>(t[c])] >= 0;
    if (above[0] == above[1] && above[1] == above[2]) continue;
    Edge from, to;
    for (int c = 0; c < 3; ++c) {
      const int next = (c + 1) % 3;
      if (above[c] && !above[next]) from = edge_between(t[c], t[next]);
      if (!above[c] && above[next]) to = edge_between(t[c], t[next]);
    }
    steps[from] = {to};
  }
  return steps;
}

/// The edges from `at` on, up to one that was followed before or that no step leaves.
std::vector<Edge> followed(Steps& steps, Steps::iterator at) {
  std::vector<Edge> edges = {at->first};
  while (at != steps.end() && !at->second.used) {
    at->second.used = true;
    edges.push_back(at->second.next);
    at = steps.find(at->second.next);
  }
  return edges;
}

/// Takes the lines that end where they begin out of `steps`.
std::vector<std::vector<Edge>> take_loops(Steps& steps) {
  std::vector<std::vector<Edge>> loops;
  Steps rest;
  for (auto at = steps.begin(); at != steps.end(); ++at) {
    if (at->second.used) continue;
    std::vector<Edge> edges = followed(steps, at);
    if (edges.back() == edges.front()) {
      edges.pop_back();
      loops.push_back(std::move(edges));
      continue;
    }
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) rest[edges[i]] = {edges[i + 1]};
  }
  steps = std::move(rest);
  return loops;
}

/// The lines of what is left, each from one end to the other.
std::vector<std::vector<Edge>> take_open_lines(Steps& steps) {
  std::set<Edge> reached;
  for (const auto& [edge, step] : steps) reached.insert(step.next);
  std::vector<std::vector<Edge>> lines;
  for (auto at = steps.begin(); at != steps.end(); ++at)
    if (!reached.contains(at->first)) lines.push_back(followed(steps, at));
  return lines;
}

}  // namespace

SectionLines section_lines(const TriangleMesh& mesh, const SlicePose& pose) {
  std::vector<double> height_mm(mesh.vertices_mm.size());
  std::transform(mesh.vertices_mm.begin(), mesh.vertices_mm.end(), height_mm.begin(),
                 [&](const Eigen::Vector3d& v) { return pose.signed_distance_mm(v); });
  const auto points_of = [&](const std::vector<Edge>& edges) {
    std::vector<Eigen::Vector2d> points;
    for (const auto& [a, b] : edges) {
      const auto from = static_cast<std::size_t>(a), to = static_cast<std::size_t>(b);
      const double share = height_mm[from] / (height_mm[from] - height_mm[to]);
      points.push_back(
          pose.world_to_slice(mesh.vertices_mm[from] + share * (mesh.vertices_mm[to] - mesh.vertices_mm[from])));
    }
    return points;
  };
  Steps steps = steps_through(mesh, height_mm);
  SectionLines lines;
  for (const std::vector<Edge>& loop : take_loops(steps))
    if (loop.size() >= 3) lines.closed.push_back({.points_mm = points_of(loop)});
  for (const std::vector<Edge>& line : take_open_lines(steps)) lines.open.push_back(points_of(line));
  orient_by_nesting(lines.closed);
  return lines;
}

std::vector<Contour> plane_section(const TriangleMesh& mesh, const SlicePose& pose) {
  return section_lines(mesh, pose).closed;
}

}  // namespace isostack
