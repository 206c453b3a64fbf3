#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/subdivision/contour_levels.h"
#include "recon/subdivision/simplicial_mesh.h"

namespace isostack {

/// A figure at its place on the blending axis.
struct FigureLayer {
  double t_mm = 0;
  std::vector<Contour> contours;  ///< oriented and nested, all in one frame
  /// A topological key shape: it says how parts join and split, by curves that touch; the interpolator need not meet
  /// it exactly. Others are sources, which the interpolator meets.
  bool topological = false;
};

/// A point of a source: its contour there and the number of the point within it.
struct SourcePoint {
  int layer = 0, contour = 0, point = 0;
};

/// A contour of a source within the interpolator.
struct SourceLoop {
  int layer = 0, contour = 0;
  ContourLevels levels;
  std::vector<int> vertices;  ///< the base vertices' numbers in the interpolator
};

/// Level 0 of the interpolator of figures: triangles in (x, y, t), outside out, whose every section between the first
/// and the last t is a set of closed curves.
struct FigureInterpolator {
  SimplicialMesh base;
  std::vector<SourceLoop> sources;
  std::vector<int> key_vertices;  ///< base vertices that topological key shapes gave
};

struct FigureInterpolatorOptions {
  ContourLevelsOptions contours;  ///< `kept` is set here
  /// Points of neighbouring sources that belong together: an edge joins them, or a chain by way of a key shape that is
  /// proposed here. Where one is given between them, they are base vertices and no more.
  std::vector<std::array<SourcePoint, 2>> features = {};
};

/// Initial meshing (Ohbuchi, Kokojima & Takahashi 2001, Section 2.1, step 1): contours that belong together are joined
/// by triangles between closest points. Where a figure has more contours than the next, and no topological key shape
/// between them says otherwise, these are proposed: half-way, contours left over join the nearest of their kind, or,
/// when there is none, shrink to a point. Layers ascend in t; the first and the last are sources.
/// Throws InputError when features cross.
FigureInterpolator figure_interpolator(const std::vector<FigureLayer>& layers,
                                       const FigureInterpolatorOptions& options);

}  // namespace isostack
