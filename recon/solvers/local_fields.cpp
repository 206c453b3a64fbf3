#include "recon/solvers/local_fields.h"

#include <oneapi/tbb/parallel_for.h>

#include "recon/solvers/interactions.h"
#include "recon/solvers/target_field.h"

namespace isostack {

namespace {

/// Level and place in one number: a leading 1, then `level` bits per axis.
std::uint64_t key_of(int level, const Octree::Cell& cell) {
  std::uint64_t key = 1;
  for (const int place : cell.place) key = key << level | static_cast<std::uint64_t>(place);
  return key;
}

template <class Visit>
void for_each_leaf(const Octree& tree, Visit visit) {
  for (int l = 0; l < tree.level_count(); ++l)
    for (std::uint32_t c = 0; c < tree.level(l).size(); ++c)
      if (tree.level(l)[c].leaf()) visit(l, c);
}

}  // namespace

LocalFields::Leaves LocalFields::at(const Octree& targets) {
  const std::lock_guard lock(mutex_);
  Leaves leaves(static_cast<std::size_t>(targets.level_count()));
  for (int l = 0; l < targets.level_count(); ++l) leaves[static_cast<std::size_t>(l)].resize(targets.level(l).size());
  std::vector<Eigen::Vector3d> missing;
  for_each_leaf(targets, [&](int l, std::uint32_t c) {
    const Octree::Cell& cell = targets.level(l)[c];
    const auto found = leaves_.find(key_of(l, cell));
    if (found != leaves_.end())
      leaves[static_cast<std::size_t>(l)][c] = found->second;
    else
      missing.push_back(targets.domain().centre + targets.cell_centre(l, cell));
  });
  if (missing.empty()) return leaves;
  // A tree of the missing leaves alone: one point, the centre, stands for each.
  compute(Octree(Eigen::Map<const Eigen::Matrix3Xd>(missing.front().data(), 3, std::ssize(missing)), sources_.tree()));
  for_each_leaf(targets, [&](int l, std::uint32_t c) {
    auto& leaf = leaves[static_cast<std::size_t>(l)][c];
    if (!leaf) leaf = leaves_.at(key_of(l, targets.level(l)[c]));
  });
  if (bytes_ > kept_bytes_) {
    leaves_.clear();
    bytes_ = 0;
  }
  return leaves;
}

void LocalFields::compute(const Octree& cells) {
  const Interactions interactions(cells, sources_.tree());
  TargetField field(sources_, cells, interactions);
  field.receive(sources_);
  for (int l = SourceField::top_level; l < cells.level_count(); ++l) {
    const std::size_t nodes = sources_.level(l).grid.node_count();
    std::vector<std::shared_ptr<const Leaf>> computed(cells.level(l).size());
    tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(computed.size()), [&](std::uint32_t c) {
      if (!cells.level(l)[c].leaf()) return;
      const ExpansionView view = field.expansion(sources_, l, c);
      const auto near = interactions.levels[static_cast<std::size_t>(l)].near_of(c);
      auto leaf = std::make_shared<Leaf>();
      leaf->far.resize(nodes);
      for (std::size_t q = 0; q < nodes; ++q) leaf->far[q] = view.values[q * view.stride];
      leaf->near.assign(near.begin(), near.end());
      computed[c] = std::move(leaf);
    });
    for (std::uint32_t c = 0; c < computed.size(); ++c) {
      if (!computed[c]) continue;
      bytes_ += nodes * sizeof(double) + computed[c]->near.size() * sizeof(computed[c]->near[0]) + 128;
      leaves_.emplace(key_of(l, cells.level(l)[c]), std::move(computed[c]));
    }
  }
}

}  // namespace isostack
