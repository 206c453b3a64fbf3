#include "recon/solvers/target_field.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace isostack {

TargetField::TargetField(const SourceField& sources, const Octree& tree, const Interactions& interactions)
    : tree_(tree), levels_(static_cast<std::size_t>(tree.level_count())) {
  for (int l = SourceField::top_level; l < tree.level_count(); ++l) {
    Level& level = levels_[static_cast<std::size_t>(l)];
    const SourceField::Level& source = sources.level(l);
    level.groups = SiblingGroups(tree, l);
    level.locals.resize(level.groups.groups.size() * source.group_doubles());
    list_terms(level, source.table, interactions.levels[static_cast<std::size_t>(l)]);
    cut_into_chunks(level, source.dft.frequency_count());
  }
}

void TargetField::list_terms(Level& level, const TranslationTable& table, const Interactions::Level& lists) {
  for (const SiblingGroups::Group& group : level.groups.groups)
    for (std::uint32_t c = group.first; c < group.last; c += quad)
      level.quads.push_back({c, std::min(c + static_cast<std::uint32_t>(quad), group.last), 0, 0});
  std::vector<std::vector<QuadTerm>> terms(level.quads.size());
  tbb::parallel_for(std::size_t{0}, level.quads.size(), [&](std::size_t q) {
    struct Entry {
      std::uint32_t source, place, slot;
    };
    std::vector<Entry> entries;
    for (std::uint32_t c = level.quads[q].first_cell; c < level.quads[q].last_cell; ++c)
      for (std::uint32_t k = lists.far_begin[c]; k < lists.far_begin[c + 1]; ++k)
        entries.push_back({lists.far[k].source, c - level.quads[q].first_cell, table.slot(lists.far[k].offset)});
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.source < b.source; });
    for (const Entry& entry : entries) {
      if (terms[q].empty() || terms[q].back().source != entry.source) {
        terms[q].push_back({entry.source, {}});
        terms[q].back().slots.fill(table.empty_slot());
      }
      terms[q].back().slots[entry.place] = entry.slot;
    }
  });
  for (std::size_t q = 0; q < level.quads.size(); ++q) {
    level.quads[q].first_term = static_cast<std::uint32_t>(level.terms.size());
    level.terms.insert(level.terms.end(), terms[q].begin(), terms[q].end());
    level.quads[q].last_term = static_cast<std::uint32_t>(level.terms.size());
  }
}

void TargetField::cut_into_chunks(Level& level, std::size_t frequencies) {
  const std::size_t spectrum_bytes = frequencies * 2 * sizeof(double);
  const std::size_t most_quads = std::clamp<std::size_t>((std::size_t{4} << 20) / quad / spectrum_bytes, 4, 128);
  Chunk chunk{0, 0, 0, 0};
  for (std::uint32_t g = 0; g < level.groups.groups.size(); ++g) {
    const SiblingGroups::Group& group = level.groups.groups[g];
    chunk.last_quad +=
        (group.last - group.first + static_cast<std::uint32_t>(quad) - 1) / static_cast<std::uint32_t>(quad);
    chunk.last_group = g + 1;
    if (chunk.last_quad - chunk.first_quad < most_quads && g + 1 < level.groups.groups.size()) continue;
    level.chunks.push_back(chunk);
    chunk = {g + 1, g + 1, chunk.last_quad, chunk.last_quad};
  }
}

void TargetField::receive(const SourceField& sources) {
  for (int l = SourceField::top_level; l < tree_.level_count(); ++l) {
    Level& level = levels_[static_cast<std::size_t>(l)];
    if (level.terms.empty()) {
      std::fill(level.locals.begin(), level.locals.end(), 0.0);
      continue;
    }
    tbb::parallel_for(std::size_t{0}, level.chunks.size(),
                      [&](std::size_t k) { translate_chunk(sources, l, level.chunks[k]); });
  }
  distribute(sources);
}

void TargetField::translate_chunk(const SourceField& sources, int l, const Chunk& chunk) {
  Level& level = levels_[static_cast<std::size_t>(l)];
  const SourceField::Level& source = sources.level(l);
  const auto& cells = tree_.level(l);
  const std::size_t frequencies = source.dft.frequency_count(), blocks = block_count(source.dft);
  const std::size_t source_stride = sources.tree().level(l).size() * block_doubles;
  const std::size_t quad_doubles = quad * block_doubles, stride = (chunk.last_quad - chunk.first_quad) * quad_doubles;
  thread_local std::vector<double> sums, re, im, scratch;
  sums.resize(blocks * stride);
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::uint32_t q = chunk.first_quad; q < chunk.last_quad; ++q) {
      const TargetQuad& four = level.quads[q];
      sum_spectrum_block(level.terms.data() + four.first_term, four.last_term - four.first_term, source.table.block(b),
                         source.spectra.data() + b * source_stride,
                         sums.data() + b * stride + (q - chunk.first_quad) * quad_doubles);
    }
  const std::array<int, 3> counts{source.grid.count(0), source.grid.count(1), source.grid.count(2)};
  std::uint32_t q = chunk.first_quad;
  for (std::uint32_t g = chunk.first_group; g < chunk.last_group; ++g) {
    re.assign(frequencies * sibling_lanes, 0.0);
    im.assign(frequencies * sibling_lanes, 0.0);
    for (; q < chunk.last_quad && level.quads[q].first_cell < level.groups.groups[g].last; ++q)
      for (std::uint32_t c = level.quads[q].first_cell; c < level.quads[q].last_cell; ++c)
        load_lane(sums.data() + (q - chunk.first_quad) * quad_doubles + (c - level.quads[q].first_cell) * block_doubles,
                  stride, frequencies, static_cast<std::size_t>(cells[c].octant()), re.data(), im.data());
    source.dft.inverse(counts, re.data(), im.data(), level.locals.data() + g * source.group_doubles(), scratch);
  }
}

void TargetField::distribute(const SourceField& sources) {
  for (int l = SourceField::top_level; l + 1 < tree_.level_count(); ++l) {
    const Level& level = levels_[static_cast<std::size_t>(l)];
    Level& finer = levels_[static_cast<std::size_t>(l) + 1];
    const auto& cells = tree_.level(l);
    const std::size_t size = sources.level(l).group_doubles(), finer_size = sources.level(l + 1).group_doubles();
    tbb::parallel_for(std::size_t{0}, finer.groups.groups.size(), [&](std::size_t g) {
      const std::uint32_t parent = finer.groups.groups[g].parent;
      const double* lane = level.locals.data() + level.groups.group_of_cell[parent] * size + cells[parent].octant();
      add_parent_to_siblings(sources.transfer(l), lane, finer.locals.data() + g * finer_size);
    });
  }
}

void TargetField::add_at_leaf(const SourceField& sources, int l, std::uint32_t cell, const SumArrays& sums) const {
  if (l < SourceField::top_level) return;
  const Level& level = levels_[static_cast<std::size_t>(l)];
  const SourceField::Level& source = sources.level(l);
  const Octree::Cell& leaf = tree_.level(l)[cell];
  const double* lane = level.locals.data() + level.groups.group_of_cell[cell] * source.group_doubles() + leaf.octant();
  add_expansion_at_points(source.grid, cell_frame(tree_, l, cell), lane, points_of(tree_, leaf), sums);
}

std::size_t TargetField::bytes() const {
  std::size_t sum = 0;
  for (const Level& level : levels_)
    sum += level.locals.size() * sizeof(double) + level.terms.size() * sizeof(QuadTerm);
  return sum;
}

}  // namespace isostack
