#include "recon/solvers/source_field.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace isostack {

int order_at(const FarFieldOptions& options, int levels_above) {
  const int order = options.order + static_cast<int>(std::lround(options.order_growth * std::max(0, levels_above)));
  return std::min(order, std::max(options.order, options.most_order));
}

SourceField::SourceField(const RadialFunction& function, const Octree& tree, const std::array<bool, 3>& flat,
                         const FarFieldOptions& options)
    : tree_(tree), levels_(static_cast<std::size_t>(tree.level_count())) {
  for (int l = top_level; l < level_count(); ++l) {
    Level& level = levels_[static_cast<std::size_t>(l)];
    level.grid = NodeGrid(order_at(options, tree.depth() - l), flat);
    level.dft = GridDft(level.grid);
    level.table = TranslationTable(function, level.grid, level.dft, tree.cell_width(l));
    level.groups = SiblingGroups(tree, l);
    level.multipoles.reset(new double[level.groups.groups.size() * level.group_doubles()]);
    level.spectra.reset(new double[level.spectrum_doubles()]);
  }
  const NodeGrid none(2, flat);
  for (int l = 0; l + 1 < level_count(); ++l)
    transfers_.push_back(l < top_level ? GridTransfer(none, none) : GridTransfer(level(l + 1).grid, level(l).grid));
}

void SourceField::prepare(const Interactions& interactions) {
  const int count = std::min(level_count(), static_cast<int>(interactions.levels.size()));
  for (int l = top_level; l < count; ++l) {
    std::vector<bool> used(Interactions::offset_count, false);
    for (const Interactions::Far& far : interactions.levels[static_cast<std::size_t>(l)].far) used[far.offset] = true;
    Level& level = levels_[static_cast<std::size_t>(l)];
    level.table.add(level.dft, used);
  }
}

void SourceField::gather(const double* weights) {
  for (int l = level_count() - 1; l >= top_level; --l) {
    gather_level(l, weights);
    transform_level(l);
  }
}

void SourceField::gather_level(int l, const double* weights) {
  Level& level = levels_[static_cast<std::size_t>(l)];
  const auto& cells = tree_.level(l);
  tbb::enumerable_thread_specific<TransferScratch> scratch;
  tbb::parallel_for(std::size_t{0}, level.groups.groups.size(), [&](std::size_t g) {
    double* group = level.multipoles.get() + g * level.group_doubles();
    std::fill_n(group, level.group_doubles(), 0.0);
    for (std::uint32_t c = level.groups.groups[g].first; c < level.groups.groups[g].last; ++c) {
      double* lane = group + cells[c].octant();
      if (cells[c].leaf()) {
        add_points_to_expansion(level.grid, cell_frame(tree_, l, c), points_of(tree_, cells[c]),
                                weights + cells[c].first, lane);
      } else {
        const Level& finer = levels_[static_cast<std::size_t>(l) + 1];
        const std::size_t children = finer.groups.group_of_cell[cells[c].first_child];
        add_siblings_to_parent(transfer(l), finer.multipoles.get() + children * finer.group_doubles(), lane,
                               scratch.local());
      }
    }
  });
}

void SourceField::transform_level(int l) {
  Level& level = levels_[static_cast<std::size_t>(l)];
  const auto& cells = tree_.level(l);
  const std::size_t frequencies = level.dft.frequency_count(), stride = cells.size() * block_doubles;
  const std::array<int, 3> nodes{level.grid.count(0), level.grid.count(1), level.grid.count(2)};
  struct Scratch {
    std::vector<double> re, im, halfway;
  };
  tbb::enumerable_thread_specific<Scratch> scratch;
  tbb::parallel_for(std::size_t{0}, level.groups.groups.size(), [&](std::size_t g) {
    auto& [re, im, halfway] = scratch.local();
    re.resize(frequencies * sibling_lanes);
    im.resize(frequencies * sibling_lanes);
    level.dft.forward(nodes, level.multipoles.get() + g * level.group_doubles(), re.data(), im.data(), halfway);
    for (std::uint32_t c = level.groups.groups[g].first; c < level.groups.groups[g].last; ++c)
      store_lane(re.data(), im.data(), frequencies, static_cast<std::size_t>(cells[c].octant()),
                 level.spectra.get() + c * block_doubles, stride);
  });
}

std::size_t SourceField::bytes() const {
  std::size_t sum = 0;
  for (const Level& level : levels_)
    sum += (level.groups.groups.size() * level.group_doubles() + level.spectrum_doubles()) * sizeof(double) +
           level.table.bytes();
  return sum;
}

}  // namespace isostack
