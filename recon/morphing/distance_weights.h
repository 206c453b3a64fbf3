#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/morphing/key_places.h"
#include "recon/morphing/signed_distance_stack.h"

namespace isostack {

/// What each key shape's signed distance counts for at a place: on a line that of the place's t alone.
class DistanceWeights {
 public:
  DistanceWeights(KeyPlaces places, AlongNormal between);

  Eigen::VectorXd at(const Eigen::VectorXd& weights) const;
  /// On a line, at a coordinate of it.
  Eigen::VectorXd along(double coordinate) const;
  const KeyPlaces& places() const { return places_; }

 private:
  KeyPlaces places_;
  AlongNormal between_;
  std::vector<double> times_;  ///< of a line
};

}  // namespace isostack
