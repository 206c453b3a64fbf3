#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "segmentation/field.h"
#include "segmentation/lattice.h"

namespace isostack {

/// A node of the band around the curve, and what the evolution keeps there.
struct BandNode {
  std::size_t node = 0;
  float propagation = 0;          ///< of the terms that are constant in time
  float curvature_weight_mm = 0;  ///< the same
  float moved_mm = 0;             ///< how much φ has changed since it was last derived from the curve
  std::uint8_t layer = 0;         ///< steps along axes to the nearest node beside the curve; that itself is 0
  std::uint8_t sides = 0;         ///< Lattice::Sides
  bool is_asked = false;          ///< the terms that are constant in time have been
  bool has_sources = false;       ///< its RateSources hold
};

/// Where a node off the curve gets its rate from: at most one neighbour of an inner layer per axis. The weights add up
/// to 1, and hardly change while the curve moves along its normal.
template <int D>
struct RateSources {
  std::array<std::int32_t, D> slot{};  ///< indices into the band's nodes
  std::array<float, D> weight{};       ///< 0: there is none
};

/// The nodes beside the curve and two layers around them (Whitaker 1998), kept up to date as nodes change sides.
/// φ is a signed distance in mm on them; elsewhere only its sign is right. Deterministic.
template <int D>
class SparseBand {
 public:
  static constexpr std::uint8_t outside = 3;  ///< layer of a node that is not in the band

  /// Around the zero set of phi (any scale), which becomes a distance in the band. `phi` outlives the band.
  explicit SparseBand(Field<D>& phi);

  /// After nodes have changed their side: layers; distances of nodes that enter or fall back to an outer layer.
  void follow(const std::vector<std::size_t>& changed_side);
  /// Looks at those of these nodes (indices into nodes(), ascending) where φ has moved by more than `limit_mm`, and
  /// derives it anew where it is no distance any more, by a tenth of a pixel. Only there, as a good distance is better
  /// left alone: new values bend the curve a little.
  void renew(const std::vector<std::int32_t>& slots, double limit_mm);
  /// φ beyond ± `width_mm` becomes that, and so do all nodes outside the band.
  void cut_off(double width_mm);

  const Lattice<D>& lattice() const { return lattice_; }
  std::vector<BandNode>& nodes() { return nodes_; }
  /// Indices into nodes().
  const std::vector<std::int32_t>& layer(int layer) const { return layers_[static_cast<std::size_t>(layer)]; }
  /// F at the nodes beside the curve, and φ_t, which is F at the closest point of the curve; as nodes().
  std::vector<float>& speeds() { return speeds_; }
  std::vector<float>& rates() { return rates_; }
  /// Of a node in the band.
  std::size_t slot_of(std::size_t node) const { return static_cast<std::size_t>(slot_[node]); }
  /// φ_t off the curve from that of inner layers: ∇φ_t·∇φ = 0, upwind.
  float rate_from_inner(std::size_t slot) {
    if (!nodes_[slot].has_sources) find_sources(slot);
    const RateSources<D>& from = sources_[slot];
    float rate = 0;
    for (int axis = 0; axis < D; ++axis) rate += from.weight[axis] * rates_[static_cast<std::size_t>(from.slot[axis])];
    return rate;
  }

 private:
  const BandNode& at(std::size_t node) const { return nodes_[slot_of(node)]; }
  bool has(std::size_t node) const { return slot_[node] >= 0; }
  void find_sources(std::size_t slot);
  std::int32_t acquire(std::size_t node);
  std::vector<std::int32_t> region_around(const std::vector<std::size_t>& nodes);
  void set_layers(const std::vector<std::int32_t>& region);
  bool has_neighbour_in(const BandNode& at, std::uint8_t layer) const;
  void derive(const std::vector<std::int32_t>& slots);
  std::vector<std::int32_t> derive_at_once(const std::vector<std::int32_t>& slots, bool also_same_layer);
  double distance_from(const BandNode& at, bool also_same_layer) const;
  void list_layers();

  Field<D>& phi_;
  Lattice<D> lattice_;
  std::vector<std::int32_t> slot_;  ///< per node of the lattice its index in nodes_, −1 outside the band
  std::vector<BandNode> nodes_;     ///< with gaps, whose layer is `outside`
  std::vector<float> speeds_, rates_;
  std::vector<RateSources<D>> sources_;
  std::vector<std::int32_t> free_;
  std::array<std::vector<std::int32_t>, 3> layers_;
};

extern template class SparseBand<2>;
extern template class SparseBand<3>;

}  // namespace isostack
