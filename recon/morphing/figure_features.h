#pragma once

#include <array>
#include <string>
#include <vector>

#include "recon/morphing/subdivision_morph.h"
#include "recon/subdivision/figure_interpolator.h"

namespace isostack {

/// A figure as a source: its contours in the common frame, nested and oriented.
struct NamedFigure {
  std::string name;
  std::vector<Contour> contours;
};

/// Throws InputError naming the figure when a contour crosses itself or another.
void require_no_crossing(const NamedFigure& figure);

/// The points of the figures that each feature is between; [i] are those of feature i, `layer` is the figure. A place
/// between two points of a contour gets a point of its own there. Throws InputError for shapes, vertices and places
/// that are not there, and for features of figures that do not follow each other.
std::vector<std::array<SourcePoint, 2>> features_in(std::vector<NamedFigure>& figures,
                                                    const std::vector<CorrespondingPoints>& features);

}  // namespace isostack
