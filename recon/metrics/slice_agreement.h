#pragma once

#include <cstddef>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/pixel_lattice.h"

namespace isostack {

/// How contours agree with those they should be, over several slices, each in its own plane. Dice counts the pixels of
/// all slices together. Distances are between points along the curves (at most half a pixel apart) and the other's
/// curves, over the slices on which both have contours.
struct SliceAgreement {
  std::size_t slices = 0;
  std::size_t one_sided = 0;   ///< slices on which only one of the two has contours: only Dice sees them
  std::size_t missed = 0;      ///< contours of the truth farther than their own width from all that was found
  double dice = 1;             ///< 2|A∩B| / (|A|+|B|)
  bool has_distances = false;  ///< false: no slice has contours on both sides, the distances mean nothing
  double mean_mm = 0;          ///< mean of the two directions' means
  double percentile95_mm = 0;  ///< larger of the two directions' 95 % quantiles
  double largest_mm = 0;       ///< larger of the two directions' largest
};

/// Collects slices; agreement() is that of all added so far.
class SliceComparison {
 public:
  /// Both in the frame of lattice.pose.
  void add(const std::vector<Contour>& found, const std::vector<Contour>& truth, const PixelLattice& lattice);
  SliceAgreement agreement() const;

 private:
  std::size_t slices_ = 0, one_sided_ = 0, missed_ = 0;
  std::size_t in_found_ = 0, in_truth_ = 0, in_both_ = 0;  ///< pixels
  std::vector<double> to_truth_mm_, to_found_mm_;
};

}  // namespace isostack
