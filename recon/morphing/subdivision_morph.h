#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/shape.h"
#include "recon/subdivision/time_warp.h"

namespace isostack {

/// A point of a key shape: one of its vertices, or the one nearest to a place.
struct FeaturePoint {
  std::size_t shape = 0;              ///< which key shape
  std::optional<std::size_t> vertex;  ///< of all its contours' points, counted through, or of the mesh's vertices
  Eigen::VectorXd place_mm = {};      ///< without a vertex: slice mm in the first figure's pose, or world mm
};

/// Where something is at a time: the share of the way from the first key shape to the last.
struct TimedPlace {
  double t = 0;
  Eigen::VectorXd place_mm;
};

/// Two points of neighbouring key shapes become one another (Ohbuchi et al. 2001, Section 2.4.1).
struct CorrespondingPoints {
  FeaturePoint from, to;
  std::vector<TimedPlace> by_way_of = {};  ///< a curve through these; empty: straight
  bool sharp = false;                      ///< a corner there stays one all the way
};

/// The vertex of a level that is nearest to a time, and then to a place, is pulled to another place, as broadly as the
/// level is coarse (Section 2.4.3).
struct EnhancedTransition {
  int level = 1;
  TimedPlace at;
  Eigen::VectorXd to_mm;
};

/// How parts join and split between two key shapes: curves that touch at single points. Beyond that its geometry is
/// arbitrary (Section 2.1, Figure 1).
struct TopologicalKeyShape {
  std::string name;
  Shape shape;
  double t = 0.5;  ///< share of the way from the first key shape to the last
};

/// What becomes of details of the key shapes.
enum class DetailsBetween {
  fade,   ///< they are smoothed away, the finer the faster (the paper's method)
  linger  ///< those finer than the base are added to the smooth blend, in proportion to the way left (Section 4)
};

struct SubdivisionMorphOptions {
  int levels = 4;             ///< the base is subdivided so many times, at least 1
  double gamma = 4;           ///< weights of the levels, γ^(k - K) (eq. A.2)
  int smoothing_passes = 16;  ///< at each level; 0 smooths nothing
  DetailsBetween details = DetailsBetween::fade;
  std::optional<double> sharp_angle_rad = {};  ///< figures: vertices turning less are rounded; bodies: edges kept
  std::optional<double> spacing_mm = {};       ///< between neighbouring key shapes; unset: half the box's longest side
  double tolerance_share = 0.005;  ///< figures: how far the base polygons may be off, in diagonals of the box
  std::vector<CorrespondingPoints> features = {};
  std::vector<EnhancedTransition> transitions = {};
  std::vector<TopologicalKeyShape> key_shapes = {};
  TimeWarp warp = {};
};

/// Blending by subdivision surfaces (Ohbuchi, Kokojima & Takahashi 2001): key shapes on a line of times are joined by
/// an interpolator of one dimension more, which is subdivided, optimised level by level, and cut at the frames' times.
/// Frames at the key shapes' times have all their vertices. The report's "constraints" are the vertices held.
/// Throws InputError for shapes that do not fit together, contours that cross, features that name no vertex, key shapes
/// outside the range of times or of figures that do not touch their neighbours' topology, and levels out of range.
Morph subdivision_morph(const std::vector<KeyShape>& shapes, const SubdivisionMorphOptions& options,
                        const Progress& progress = {});

}  // namespace isostack
