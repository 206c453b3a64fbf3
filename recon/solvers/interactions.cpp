#include "recon/solvers/interactions.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstdlib>

namespace isostack {

namespace {

using Range = std::pair<std::uint32_t, std::uint32_t>;

/// What a target cell knows of the sources around it while the trees are descended.
struct Surroundings {
  std::vector<std::uint32_t> adjacent;  ///< source cells of the same level that touch it
  std::vector<Range> direct;            ///< points of coarser source leaves that touch it
  std::vector<Interactions::Far> far;
};

bool touch(const Octree::Cell& a, const Octree::Cell& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::abs(a.place[axis] - b.place[axis]) > 1) return false;
  return true;
}

Surroundings descend(const Surroundings& parent, const Octree::Cell& child, const std::vector<Octree::Cell>& sources,
                     const std::vector<Octree::Cell>& source_children) {
  Surroundings result;
  result.direct = parent.direct;
  for (const std::uint32_t s : parent.adjacent) {
    const Octree::Cell& source = sources[s];
    if (source.leaf()) result.direct.emplace_back(source.first, source.last);
    for (std::uint32_t c = source.first_child; c < source.last_child; ++c) {
      if (touch(child, source_children[c]))
        result.adjacent.push_back(c);
      else
        result.far.push_back(
            {static_cast<std::uint32_t>(Interactions::offset_index(child.place, source_children[c].place)), c});
    }
  }
  return result;
}

std::vector<Range> near_ranges(const Surroundings& around, const std::vector<Octree::Cell>& sources) {
  std::vector<Range> ranges = around.direct;
  for (const std::uint32_t s : around.adjacent) ranges.emplace_back(sources[s].first, sources[s].last);
  std::sort(ranges.begin(), ranges.end());
  std::vector<Range> merged;
  for (const Range& range : ranges) {
    if (!merged.empty() && merged.back().second == range.first)
      merged.back().second = range.second;
    else
      merged.push_back(range);
  }
  return merged;
}

template <class Item, class ListOf>
void flatten(std::size_t count, ListOf list_of, std::vector<std::uint32_t>& begin, std::vector<Item>& items) {
  begin.assign(count + 1, 0);
  for (std::size_t c = 0; c < count; ++c) begin[c + 1] = begin[c] + static_cast<std::uint32_t>(list_of(c).size());
  items.reserve(begin.back());
  for (std::size_t c = 0; c < count; ++c) items.insert(items.end(), list_of(c).begin(), list_of(c).end());
}

}  // namespace

Interactions::Interactions(const Octree& targets, const Octree& sources)
    : levels(static_cast<std::size_t>(targets.level_count())) {
  static const std::vector<Octree::Cell> none;
  std::vector<Surroundings> around(1);
  around[0].adjacent = {0};
  for (int l = 0; l < targets.level_count(); ++l) {
    const auto& cells = targets.level(l);
    const auto& source_cells = l < sources.level_count() ? sources.level(l) : none;
    const auto& source_children = l + 1 < sources.level_count() ? sources.level(l + 1) : none;
    std::vector<std::vector<Range>> near(cells.size());
    std::vector<Surroundings> next(l + 1 < targets.level_count() ? targets.level(l + 1).size() : 0);
    tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t c) {
      if (cells[c].leaf()) near[c] = near_ranges(around[c], source_cells);
      for (std::uint32_t child = cells[c].first_child; child < cells[c].last_child; ++child)
        next[child] = descend(around[c], targets.level(l + 1)[child], source_cells, source_children);
    });
    Level& level = levels[static_cast<std::size_t>(l)];
    flatten(
        cells.size(), [&](std::size_t c) -> const auto& { return around[c].far; }, level.far_begin, level.far);
    flatten(
        cells.size(), [&](std::size_t c) -> const auto& { return near[c]; }, level.near_begin, level.near);
    far_pairs += static_cast<double>(level.far.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (const Range& range : near[c])
        near_pairs += static_cast<double>(cells[c].count()) * (range.second - range.first);
    around = std::move(next);
  }
}

}  // namespace isostack
