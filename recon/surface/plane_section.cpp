#include "recon/surface/plane_section.h"

#include <algorithm>
#include <cstdint>
#include <map>
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

/// Each triangle cut by the plane leads from one of its edges to another, the inside (its back) to the left.
std::map<Edge, Step> steps_through(const TriangleMesh& mesh, const std::vector<double>& height_mm) {
  std::map<Edge, Step> steps;
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

}  // namespace

std::vector<Contour> plane_section(const TriangleMesh& mesh, const SlicePose& pose) {
  std::vector<double> height_mm(mesh.vertices_mm.size());
  std::transform(mesh.vertices_mm.begin(), mesh.vertices_mm.end(), height_mm.begin(),
                 [&](const Eigen::Vector3d& v) { return pose.signed_distance_mm(v); });
  const auto crossing = [&](const Edge& edge) -> Eigen::Vector2d {
    const auto a = static_cast<std::size_t>(edge.first), b = static_cast<std::size_t>(edge.second);
    const double share = height_mm[a] / (height_mm[a] - height_mm[b]);
    return pose.world_to_slice(mesh.vertices_mm[a] + share * (mesh.vertices_mm[b] - mesh.vertices_mm[a]));
  };
  std::map<Edge, Step> steps = steps_through(mesh, height_mm);
  std::vector<Contour> contours;
  for (auto& [start, first] : steps) {
    if (first.used) continue;
    Contour contour;
    auto at = steps.find(start);
    while (at != steps.end() && !at->second.used) {
      at->second.used = true;
      contour.points_mm.push_back(crossing(at->first));
      at = steps.find(at->second.next);
    }
    const bool closed = at != steps.end() && at->first == start;
    if (closed && contour.points_mm.size() >= 3) contours.push_back(std::move(contour));
  }
  orient_by_nesting(contours);
  return contours;
}

}  // namespace isostack
