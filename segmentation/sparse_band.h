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
  float speed = 0;                ///< F at the node
  float rate = 0;                 ///< φ_t: F at the closest point of the curve
  float moved_mm = 0;             ///< how much φ has changed since it was last derived from the curve
  std::uint8_t layer = 0;         ///< steps along axes to the nearest node beside the curve; that itself is 0
  std::uint8_t sides = 0;         ///< Lattice::Sides
  bool is_asked = false;          ///< the terms that are constant in time have been
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
  /// Looks at the nodes where φ has moved by more than `limit_mm`, and derives it anew where it is no distance any
  /// more, by a tenth of a pixel. Only there, as a good distance is better left alone: new values bend the curve a
  /// little.
  void renew(double limit_mm);

  const Lattice<D>& lattice() const { return lattice_; }
  std::vector<BandNode>& nodes() { return nodes_; }
  /// Indices into nodes().
  const std::vector<std::int32_t>& layer(int layer) const { return layers_[static_cast<std::size_t>(layer)]; }
  /// Of a node in the band.
  const BandNode& at(std::size_t node) const { return nodes_[static_cast<std::size_t>(slot_[node])]; }
  bool has(std::size_t node) const { return slot_[node] >= 0; }

 private:
  std::int32_t acquire(std::size_t node);
  std::vector<std::int32_t> region_around(const std::vector<std::size_t>& nodes);
  void set_layers(const std::vector<std::int32_t>& region);
  bool has_neighbour_in(const BandNode& at, std::uint8_t layer) const;
  void derive(const std::vector<std::int32_t>& slots);
  void derive_at_once(const std::vector<std::int32_t>& slots, bool also_same_layer);
  double distance_from(const BandNode& at, bool also_same_layer) const;
  void list_layers();

  Field<D>& phi_;
  Lattice<D> lattice_;
  std::vector<std::int32_t> slot_;  ///< per node of the lattice its index in nodes_, −1 outside the band
  std::vector<BandNode> nodes_;     ///< with gaps, whose layer is `outside`
  std::vector<std::int32_t> free_;
  std::array<std::vector<std::int32_t>, 3> layers_;
};

extern template class SparseBand<2>;
extern template class SparseBand<3>;

}  // namespace isostack
