#include "recon/solvers/target_field.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace isostack {

TargetField::TargetField(SourceField& sources, const Octree& tree, const Interactions& interactions)
    : tree_(tree), levels_(static_cast<std::size_t>(tree.level_count())) {
  sources.prepare(interactions);
  for (int l = SourceField::top_level; l < tree.level_count(); ++l) {
    Level& level = levels_[static_cast<std::size_t>(l)];
    const SourceField::Level& source = sources.level(l);
    level.groups = SiblingGroups(tree, l);
    level.locals.reset(new double[level.groups.groups.size() * source.group_doubles()]);
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
  tbb::enumerable_thread_specific<Scratch> scratch;
  for (int l = SourceField::top_level; l < tree_.level_count(); ++l) {
    Level& level = levels_[static_cast<std::size_t>(l)];
    if (level.terms.empty()) {
      std::fill_n(level.locals.get(), level.groups.groups.size() * sources.level(l).group_doubles(), 0.0);
      continue;
    }
    tbb::parallel_for(std::size_t{0}, level.chunks.size(),
                      [&](std::size_t k) { translate_chunk(sources, l, level.chunks[k], scratch.local()); });
  }
  distribute(sources);
}

void TargetField::translate_chunk(const SourceField& sources, int l, const Chunk& chunk, Scratch& scratch) {
  Level& level = levels_[static_cast<std::size_t>(l)];
  const SourceField::Level& source = sources.level(l);
  const auto& cells = tree_.level(l);
  const std::size_t frequencies = source.dft.frequency_count(), blocks = block_count(source.dft);
  const std::size_t source_stride = sources.tree().level(l).size() * block_doubles;
  const std::size_t quad_doubles = quad * block_doubles, stride = (chunk.last_quad - chunk.first_quad) * quad_doubles;
  auto& [sums, re, im, halfway] = scratch;
  sums.resize(blocks * stride);
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::uint32_t q = chunk.first_quad; q < chunk.last_quad; ++q) {
      const TargetQuad& four = level.quads[q];
      sum_spectrum_block(level.terms.data() + four.first_term, four.last_term - four.first_term, source.table.block(b),
                         source.spectra.get() + b * source_stride,
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
    source.dft.inverse(counts, re.data(), im.data(), level.locals.get() + g * source.group_doubles(), halfway);
  }
}

void TargetField::distribute(const SourceField& sources) {
  for (int l = SourceField::top_level; l + 1 < tree_.level_count(); ++l) {
    const Level& level = levels_[static_cast<std::size_t>(l)];
    Level& finer = levels_[static_cast<std::size_t>(l) + 1];
    const auto& cells = tree_.level(l);
    const std::size_t size = sources.level(l).group_doubles(), finer_size = sources.level(l + 1).group_doubles();
    tbb::enumerable_thread_specific<TransferScratch> scratch;
    tbb::parallel_for(std::size_t{0}, finer.groups.groups.size(), [&](std::size_t g) {
      const std::uint32_t parent = finer.groups.groups[g].parent;
      const double* lane = level.locals.get() + level.groups.group_of_cell[parent] * size + cells[parent].octant();
      add_parent_to_siblings(sources.transfer(l), lane, finer.locals.get() + g * finer_size, scratch.local());
    });
  }
}

ExpansionView TargetField::expansion(const SourceField& sources, int l, std::uint32_t cell) const {
  const Level& level = levels_[static_cast<std::size_t>(l)];
  const double* group = level.locals.get() + level.groups.group_of_cell[cell] * sources.level(l).group_doubles();
  return {group + tree_.level(l)[cell].octant(), sibling_lanes};
}

std::size_t TargetField::bytes(const SourceField& sources) const {
  std::size_t sum = 0;
  for (int l = SourceField::top_level; l < tree_.level_count(); ++l) {
    const Level& level = levels_[static_cast<std::size_t>(l)];
    sum += level.groups.groups.size() * sources.level(l).group_doubles() * sizeof(double) +
           level.terms.size() * sizeof(QuadTerm);
  }
  return sum;
}

}  // namespace isostack
