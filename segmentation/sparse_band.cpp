#include "segmentation/sparse_band.h"

#include <algorithm>
#include <cmath>

#include "segmentation/curve_distance.h"
#include "segmentation/eikonal.h"
#include "segmentation/pieces.h"

namespace isostack {

template <int D>
SparseBand<D>::SparseBand(Field<D>& phi) : phi_(phi), lattice_(phi), slot_(phi.values.size(), -1) {
  const auto beside = nodes_beside_curve(phi_, lattice_);
  set_distances_beside_curve(phi_, lattice_, beside);
  const std::size_t expected = 7 * beside.size() / 2;
  nodes_.reserve(expected);
  speeds_.reserve(expected);
  rates_.reserve(expected);
  sources_.reserve(expected);
  for (const std::size_t node : beside) nodes_[static_cast<std::size_t>(acquire(node))].layer = 0;
  std::vector<std::int32_t> around;
  std::size_t first = 0;
  for (std::uint8_t layer = 1; layer < outside; ++layer) {
    const std::size_t last = nodes_.size();
    for (std::size_t i = first; i < last; ++i) {
      const BandNode from = nodes_[i];
      lattice_.for_each_neighbour(from.sides, [&](int, std::ptrdiff_t step) {
        const std::size_t there = lattice_.moved(from.node, step);
        if (has(there)) return;
        around.push_back(acquire(there));
        nodes_.back().layer = layer;
      });
    }
    first = last;
  }
  list_layers();
  derive(around);
}

template <int D>
std::int32_t SparseBand<D>::acquire(std::size_t node) {
  std::int32_t& slot = slot_[node];
  if (slot >= 0) return slot;
  if (free_.empty()) {
    slot = static_cast<std::int32_t>(nodes_.size());
    nodes_.emplace_back();
    speeds_.push_back(0);
    rates_.push_back(0);
    sources_.emplace_back();
  } else {
    slot = free_.back();
    free_.pop_back();
  }
  BandNode& fresh = nodes_[static_cast<std::size_t>(slot)];
  fresh = {};
  fresh.node = node;
  fresh.layer = outside;
  fresh.sides = lattice_.sides_of(node);
  return slot;
}

/// All nodes whose layer may have changed: up to three steps away.
template <int D>
std::vector<std::int32_t> SparseBand<D>::region_around(const std::vector<std::size_t>& nodes) {
  std::vector<std::int32_t> region;
  region.reserve(4 * nodes.size());
  constexpr std::uint8_t visited = 0x80;
  const auto visit = [&](std::size_t node) {
    const std::int32_t slot = acquire(node);
    std::uint8_t& layer = nodes_[static_cast<std::size_t>(slot)].layer;
    if (layer & visited) return;
    layer |= visited;
    region.push_back(slot);
  };
  for (const std::size_t node : nodes) visit(node);
  std::size_t first = 0;
  for (int round = 0; round < outside; ++round) {
    const std::size_t last = region.size();
    for (; first < last; ++first) {
      const BandNode from = nodes_[static_cast<std::size_t>(region[first])];
      lattice_.for_each_neighbour(from.sides,
                                  [&](int, std::ptrdiff_t step) { visit(lattice_.moved(from.node, step)); });
    }
  }
  for (const std::int32_t slot : region) nodes_[static_cast<std::size_t>(slot)].layer &= ~visited & 0xFF;
  return region;
}

template <int D>
bool SparseBand<D>::has_neighbour_in(const BandNode& node, std::uint8_t layer) const {
  bool found = false;
  lattice_.for_each_neighbour(node.sides, [&](int, std::ptrdiff_t step) {
    const std::size_t there = lattice_.moved(node.node, step);
    found = found || (has(there) && at(there).layer == layer);
  });
  return found;
}

template <int D>
void SparseBand<D>::set_layers(const std::vector<std::int32_t>& region) {
  for (const std::int32_t slot : region) {
    BandNode& node = nodes_[static_cast<std::size_t>(slot)];
    node.layer = is_beside_curve(phi_, lattice_, node.node, node.sides) ? 0 : outside;
    node.has_sources = false;
  }
  for (std::uint8_t layer = 1; layer < outside; ++layer)
    for (const std::int32_t slot : region) {
      BandNode& node = nodes_[static_cast<std::size_t>(slot)];
      if (node.layer == outside && has_neighbour_in(node, static_cast<std::uint8_t>(layer - 1))) node.layer = layer;
    }
}

template <int D>
void SparseBand<D>::follow(const std::vector<std::size_t>& changed_side) {
  const auto region = region_around(changed_side);
  std::vector<std::uint8_t> before(region.size());
  for (std::size_t i = 0; i < region.size(); ++i) before[i] = nodes_[static_cast<std::size_t>(region[i])].layer;
  set_layers(region);
  std::vector<std::int32_t> lost;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const BandNode& node = nodes_[static_cast<std::size_t>(region[i])];
    if (node.layer == outside) {
      slot_[node.node] = -1;
      free_.push_back(region[i]);
    } else if (before[i] == outside || node.layer > before[i]) {
      // Entered, or the curve that gave its distance has left.
      lost.push_back(region[i]);
    }
  }
  list_layers();
  derive(lost);
}

template <int D>
void SparseBand<D>::renew(const std::vector<std::int32_t>& slots, double limit_mm) {
  constexpr double tolerance = 0.1;
  const double h_mm = phi_.smallest_spacing_mm();
  std::vector<std::int32_t> outer;
  std::vector<std::size_t> beside;
  for (const std::int32_t slot : slots) {
    BandNode& node = nodes_[static_cast<std::size_t>(slot)];
    if (node.layer == outside || !(node.moved_mm > limit_mm)) continue;
    node.moved_mm = 0;
    const double now = std::abs(static_cast<double>(phi_.values[node.node]));
    const double anew =
        node.layer == 0 ? distance_beside_curve(phi_, lattice_, node.node, node.sides) : distance_from(node, true);
    if (!(std::abs(anew - now) > tolerance * h_mm)) continue;
    if (node.layer == 0)
      beside.push_back(node.node);
    else
      outer.push_back(slot);
  }
  set_distances_beside_curve(phi_, lattice_, beside);
  derive(outer);
}

/// Distances from inner layers, then again with those of the same layer where there is a closer one beside a node:
/// three times at most, as that one may have changed as well.
template <int D>
void SparseBand<D>::derive(const std::vector<std::int32_t>& slots) {
  std::vector<std::int32_t> of_layer, among_equals;
  for (std::uint8_t layer = 1; layer < outside; ++layer) {
    of_layer.clear();
    among_equals.clear();
    for (const std::int32_t slot : slots) {
      BandNode& node = nodes_[static_cast<std::size_t>(slot)];
      if (node.layer != layer) continue;
      node.moved_mm = 0;
      node.has_sources = false;
      of_layer.push_back(slot);
      if (has_neighbour_in(node, layer)) among_equals.push_back(slot);
    }
    derive_at_once(of_layer, false);
    for (int round = 0; round < 3 && !among_equals.empty(); ++round) among_equals = derive_at_once(among_equals, true);
  }
}

/// Returns the nodes whose distance has changed by more than a hundredth of a pixel.
template <int D>
std::vector<std::int32_t> SparseBand<D>::derive_at_once(const std::vector<std::int32_t>& slots, bool also_same_layer) {
  std::vector<float> distances(slots.size());
  const Pieces pieces{slots.size(), 1 << 13};
  const auto node_of = [&](std::size_t i) -> const BandNode& { return nodes_[static_cast<std::size_t>(slots[i])]; };
  pieces.for_each([&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      distances[i] = static_cast<float>(distance_from(node_of(i), also_same_layer));
  });
  const auto tolerance = static_cast<float>(0.01 * phi_.smallest_spacing_mm());
  std::vector<std::int32_t> changed;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    float& value = phi_.values[node_of(i).node];
    const float before = value;
    value = is_inside(value) ? distances[i] : -distances[i];
    if (also_same_layer && std::abs(value - before) > tolerance) changed.push_back(slots[i]);
  }
  return changed;
}

template <int D>
double SparseBand<D>::distance_from(const BandNode& node, bool also_same_layer) const {
  const double sign = is_inside(phi_.values[node.node]) ? 1 : -1;
  const auto distance = [&](std::size_t there) { return sign * static_cast<double>(phi_.values[there]); };
  const double own = also_same_layer ? distance(node.node) : 0;
  const auto is_upwind = [&](std::size_t there) {
    if (!has(there)) return false;
    const std::uint8_t layer = at(there).layer;
    return layer < node.layer || (also_same_layer && layer == node.layer && distance(there) < own);
  };
  UpwindEikonal<D> eikonal;
  for (int axis = 0; axis < D; ++axis) {
    std::ptrdiff_t best = 0;
    for (const std::ptrdiff_t step : {-lattice_.stride[axis], lattice_.stride[axis]}) {
      if (!(node.sides & (step < 0 ? lattice_.before(axis) : lattice_.after(axis)))) continue;
      const std::size_t there = lattice_.moved(node.node, step);
      if (is_upwind(there) && (best == 0 || distance(there) < distance(lattice_.moved(node.node, best)))) best = step;
    }
    if (best == 0) continue;
    const std::size_t next = lattice_.moved(node.node, best), behind = lattice_.moved(next, best);
    const double h = lattice_.spacing_mm[axis];
    const bool has_behind = at(next).sides & (best < 0 ? lattice_.before(axis) : lattice_.after(axis));
    if (has_behind && is_upwind(behind) && distance(behind) <= distance(next))
      eikonal.add(h, distance(next), distance(behind));
    else
      eikonal.add(h, distance(next));
  }
  return eikonal.solve();
}

template <int D>
void SparseBand<D>::find_sources(std::size_t slot) {
  BandNode& node = nodes_[slot];
  RateSources<D> sources;
  const float own = std::abs(phi_.values[node.node]);
  std::int32_t any = 0;
  float sum = 0;
  lattice_.for_each_neighbour(node.sides, [&](int axis, std::ptrdiff_t step) {
    const std::size_t there = lattice_.moved(node.node, step);
    if (!has(there) || at(there).layer >= node.layer) return;
    any = slot_[there];
    const auto inverse_h = static_cast<float>(lattice_.inverse_spacing[axis]);
    const float weight = (own - std::abs(phi_.values[there])) * (inverse_h * inverse_h);
    if (!(weight > sources.weight[axis])) return;
    sum += weight - sources.weight[axis];
    sources.weight[axis] = weight;
    sources.slot[axis] = any;
  });
  if (sum > 0) {
    for (float& weight : sources.weight) weight /= sum;
  } else {
    sources.slot[0] = any;
    sources.weight[0] = 1;
  }
  sources_[slot] = sources;
  node.has_sources = true;
}

template <int D>
void SparseBand<D>::list_layers() {
  const Pieces pieces{nodes_.size(), 1 << 16};
  std::vector<std::array<std::vector<std::int32_t>, outside>> lists(pieces.number());
  pieces.for_each([&](std::size_t piece, std::size_t first, std::size_t last) {
    for (std::size_t slot = first; slot < last; ++slot)
      if (nodes_[slot].layer < outside) lists[piece][nodes_[slot].layer].push_back(static_cast<std::int32_t>(slot));
  });
  for (std::size_t layer = 0; layer < outside; ++layer) {
    layers_[layer].clear();
    for (const auto& part : lists) layers_[layer].insert(layers_[layer].end(), part[layer].begin(), part[layer].end());
  }
}

template <int D>
void SparseBand<D>::cut_off(double width_mm) {
  const auto width = static_cast<float>(width_mm);
  Pieces{slot_.size(), 1 << 18}.for_each([&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t node = first; node < last; ++node) {
      const float value = phi_.values[node];
      const float beyond = is_inside(value) ? width : -width;
      phi_.values[node] = slot_[node] < 0 || std::abs(value) > width ? beyond : value;
    }
  });
}

template class SparseBand<2>;
template class SparseBand<3>;

}  // namespace isostack
