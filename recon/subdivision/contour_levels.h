#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

struct ContourLevelsOptions {
  int levels = 4;
  /// How far the base polygon may be off the contour, mm.
  double tolerance_mm = 0.5;
  /// Unset: the contour is straight between its points. Else it goes round smoothly at points where it turns less.
  std::optional<double> sharp_angle_rad = {};
  std::vector<int> kept = {};  ///< points that are base vertices whatever happens, by their number
};

/// A contour as a base polygon whose edges are halved again and again: the multiresolution analysis of a curve. Places
/// of a level are those of the finest at multiples of a power of two, so that details are returned without loss.
struct ContourLevels {
  std::vector<double> base;    ///< base vertices on the contour: point i is i, half-way to the next i + 1/2; ascending
  int segments = 1;            ///< of each base edge at the finest level
  Eigen::Matrix2Xd places_mm;  ///< finest level: `segments` columns from each base vertex on; all points are among them

  Eigen::Index base_count() const { return static_cast<Eigen::Index>(base.size()); }
  /// On base edge `edge`, at `share` of it, in straight lines between the finest places.
  Eigen::Vector2d at(Eigen::Index edge, double share) const;
};

/// Base vertices are those of the contour that it needs, and more where edges are long. Every point of the contour gets
/// a place of its own.
ContourLevels contour_levels(const Contour& contour, const ContourLevelsOptions& options);

}  // namespace isostack
