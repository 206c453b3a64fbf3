#include "recon/subdivision/rising_chain.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "recon/subdivision/simplex_subdivision.h"

namespace isostack {

std::optional<std::vector<int>> rising_chain(const SimplicialMesh& mesh, int from, int to) {
  const Eigen::RowVectorXd t = mesh.vertices.bottomRows(1);
  if (t[from] > t[to]) {
    auto chain = rising_chain(mesh, to, from);
    if (chain) std::reverse(chain->begin(), chain->end());
    return chain;
  }
  // In the order of t every vertex is finished before those that it leads to.
  std::vector<std::array<int, 2>> edges = subdivide(mesh.simplices, mesh.vertex_count()).edges;
  for (auto& [a, b] : edges)
    if (t[a] > t[b]) std::swap(a, b);
  std::stable_sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) { return t[a[0]] < t[b[0]]; });
  std::vector<double> length(static_cast<std::size_t>(mesh.vertex_count()), std::numeric_limits<double>::infinity());
  std::vector<int> before(length.size(), -1);
  length[static_cast<std::size_t>(from)] = 0;
  for (const auto& [a, b] : edges) {
    if (!(t[a] < t[b])) continue;
    const double way = length[static_cast<std::size_t>(a)] + (mesh.vertices.col(b) - mesh.vertices.col(a)).norm();
    if (!(way < length[static_cast<std::size_t>(b)])) continue;
    length[static_cast<std::size_t>(b)] = way;
    before[static_cast<std::size_t>(b)] = a;
  }
  if (before[static_cast<std::size_t>(to)] < 0) return std::nullopt;
  std::vector<int> chain;
  for (int v = to; v >= 0; v = before[static_cast<std::size_t>(v)]) chain.push_back(v);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace isostack
