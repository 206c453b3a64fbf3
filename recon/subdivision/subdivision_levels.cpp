#include "recon/subdivision/subdivision_levels.h"

#include <algorithm>
#include <cstddef>

namespace isostack {

namespace {

/// Half of each, on the same vertices where they share some.
BasePlace half_way(const BasePlace& a, const BasePlace& b) {
  BasePlace result;
  std::size_t i = 0, j = 0, next = 0;
  const auto is_end = [](const BasePlace& place, std::size_t at) { return at == 4 || place.vertex[at] < 0; };
  while (!is_end(a, i) || !is_end(b, j)) {
    const bool from_a = !is_end(a, i) && (is_end(b, j) || a.vertex[i] <= b.vertex[j]);
    const bool from_b = !is_end(b, j) && (is_end(a, i) || b.vertex[j] <= a.vertex[i]);
    result.vertex[next] = from_a ? a.vertex[i] : b.vertex[j];
    result.weight[next++] = ((from_a ? a.weight[i] : 0) + (from_b ? b.weight[j] : 0)) / 2;
    i += from_a ? 1 : 0;
    j += from_b ? 1 : 0;
  }
  return result;
}

}  // namespace

const Eigen::MatrixXi& SubdivisionLevels::simplices(int level) const {
  return level == 0 ? base : steps[static_cast<std::size_t>(level) - 1].simplices;
}

Eigen::Index SubdivisionLevels::vertex_count(int level) const {
  Eigen::Index count = base_vertex_count;
  for (int k = 0; k < level; ++k) count += static_cast<Eigen::Index>(steps[static_cast<std::size_t>(k)].edges.size());
  return count;
}

SubdivisionLevels subdivision_levels(const Eigen::MatrixXi& base, Eigen::Index vertex_count, int levels) {
  SubdivisionLevels result{.base_vertex_count = vertex_count, .base = base, .steps = {}};
  for (int k = 0; k < levels; ++k) {
    result.steps.push_back(subdivide(result.simplices(k), vertex_count));
    vertex_count += static_cast<Eigen::Index>(result.steps.back().edges.size());
  }
  return result;
}

std::vector<BasePlace> base_places(const SubdivisionLevels& levels) {
  std::vector<BasePlace> places(static_cast<std::size_t>(levels.base_vertex_count));
  places.reserve(static_cast<std::size_t>(levels.vertex_count(levels.finest())));
  for (std::size_t v = 0; v < places.size(); ++v)
    places[v] = {.vertex = {static_cast<int>(v), -1, -1, -1}, .weight = {1, 0, 0, 0}};
  for (const SimplexSubdivision& step : levels.steps)
    for (const auto& [a, b] : step.edges)
      places.push_back(half_way(places[static_cast<std::size_t>(a)], places[static_cast<std::size_t>(b)]));
  return places;
}

std::vector<int> refined_chain(std::vector<int> chain, const SubdivisionLevels& levels, int from, int to) {
  for (int k = from; k < to; ++k) {
    const auto& edges = levels.steps[static_cast<std::size_t>(k)].edges;
    const auto coarse = static_cast<int>(levels.vertex_count(k));
    std::vector<int> finer;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      finer.push_back(chain[i]);
      if (i + 1 == chain.size()) break;
      const std::array<int, 2> edge = {std::min(chain[i], chain[i + 1]), std::max(chain[i], chain[i + 1])};
      finer.push_back(coarse + static_cast<int>(std::lower_bound(edges.begin(), edges.end(), edge) - edges.begin()));
    }
    chain = std::move(finer);
  }
  return chain;
}

}  // namespace isostack
