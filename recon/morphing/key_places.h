#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/morphing/shape.h"

namespace isostack {

/// How the key shapes lie in the extra dimensions.
enum class KeyLayout {
  line,     ///< along t, one after the other (Turk & O'Brien 1999, §5; many: §6)
  simplex,  ///< each at a corner of a regular simplex: any mixture of them has a place (§7)
  given     ///< at KeyShape::place
};

/// Where the key shapes lie in the m extra dimensions. A place is named by weights, one per key shape, ≥ 0, that sum
/// to 1; its coordinates are the weighted mean of the key shapes'.
struct KeyPlaces {
  KeyLayout layout = KeyLayout::line;
  /// m × key shapes. Unit: the mean distance between neighbours (line), the edge (simplex), or as given.
  Eigen::MatrixXd coordinates;

  Eigen::Index key_count() const { return coordinates.cols(); }
  /// Weights of the place at t in [0, 1]: along the line through all key shapes, or straight from first to last.
  /// Throws InputError for other t.
  Eigen::VectorXd weights_at(double t) const;
  Eigen::VectorXd place_at(const Eigen::VectorXd& weights) const { return coordinates * weights; }
  /// Throws InputError unless these are weights of a place.
  void require_weights(const Eigen::VectorXd& weights) const;
};

/// Throws InputError when times do not ascend, places have different sizes or coincide, or a shape lacks one.
KeyPlaces key_places(const std::vector<KeyShape>& shapes, KeyLayout layout);

/// `count` weights, evenly spaced along straight lines from each corner of a path to the next. Throws InputError for
/// a path of fewer than two corners, without length, or fewer than two frames.
std::vector<Eigen::VectorXd> weights_along_path(const std::vector<Eigen::VectorXd>& corners, std::size_t count);

}  // namespace isostack
