#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// A stretch of the line two planes share on which one slice says inside and the other outside.
struct Contradiction {
  /// An end of the stretch: where the line crosses a contour of one slice, or where a field of view ends.
  struct End {
    Eigen::Vector3d point_mm;  ///< world
    Eigen::Vector3d inward;    ///< unit normal of that contour in its slice's plane, world frame; zero at a view's end
    bool of_first = false;     ///< the contour is the pair's first slice's
  };

  std::array<End, 2> ends;
  double length_mm = 0;  ///< along the line
  /// How far apart the two contours are: the distances of the stretch's middle to both, together. Less than the length
  /// where the line grazes the contours.
  double distance_mm = 0;

  Eigen::Vector3d middle_mm() const { return (ends[0].point_mm + ends[1].point_mm) / 2; }
  /// The ends are two versions of the same crossing, one of each slice; else one slice misses a whole stretch.
  bool is_matched() const;
};

/// Two slices whose planes cross where at least one of them has the organ.
struct SlicePair {
  std::size_t first = 0, second = 0;  ///< indices into the stack
  std::string first_name, second_name;
  double line_mm = 0;                 ///< length of the line within both fields of view
  double disagreement_mm = 0;         ///< of that, where one slice says inside and the other outside
  double largest_mismatch_mm = 0;     ///< longest stretch: two versions of one interval end are that far apart
  std::vector<Contradiction> places;  ///< in order along the line
};

/// How the slices of one organ contradict each other.
struct Contradictions {
  std::vector<SlicePair> pairs;  ///< also those that agree, ordered by index

  double disagreement_mm() const;      ///< of all pairs together
  double largest_mismatch_mm() const;  ///< of any pair
};

struct CrossingOptions {
  double least_mm = 1e-6;         ///< shorter stretches are rounding
  bool refuse_duplicates = true;  ///< throw when slices in the same plane contradict each other
};

/// Compares every pair of slices along the line their planes share, within both fields of view (the images, or
/// the box of all contours where the extent is unknown). Parallel planes, and planes that cross where neither slice
/// has the organ, say nothing about each other. Throws GeometryError naming both slices when two slices in the same
/// plane (within a tenth of a pixel) have contours more than a pixel apart.
Contradictions find_contradictions(const ContourStack& stack, const CrossingOptions& options = {});

}  // namespace isostack
