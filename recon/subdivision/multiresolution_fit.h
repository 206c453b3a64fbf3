#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/subdivision/fit_report.h"
#include "recon/subdivision/simplicial_mesh.h"
#include "recon/subdivision/subdivision_levels.h"

namespace isostack {

/// Vertices of one level and where they belong: x, y(, z) in mm, one column per vertex.
struct PlacedVertices {
  std::vector<int> vertices;
  Eigen::MatrixXd places_mm;
};

/// The surface passes through a point, or along a curve (finite and transfinite constraints, Section 2.3.2), from this
/// level on: what a coarse level adds is broad, what a fine one adds is narrow.
struct FitConstraint {
  int level = 0;
  /// Of that level: one, or a chain whose neighbours are joined by edges. At finer levels the vertices that halve the
  /// chain's edges belong to it, too, so that the surface meets the curve at all of them.
  std::vector<int> vertices;
  std::function<Eigen::VectorXd(double t_mm)> place_mm;  ///< where the curve is at t: x, y(, z)
};

struct FitProblem {
  SubdivisionLevels levels;
  Eigen::MatrixXd base;  ///< vertices of level 0: x, y(, z), t, all in mm; no simplex may lie within one t
  /// [k]: vertices of the sources at level k, met exactly. All others are free.
  std::vector<PlacedVertices> held;
  /// [k], x, y(, z) of all vertices at level k before anything is smoothed. Empty: half-way between the base's.
  std::vector<Eigen::MatrixXd> reference = {};
  /// [k], the part of the reference that smoothing leaves alone: details that linger. Empty: none, so that details of
  /// the sources die away with the distance from them.
  std::vector<Eigen::MatrixXd> details = {};
  std::vector<FitConstraint> constraints = {};
  std::vector<char> sharp = {};  ///< of each vertex of the finest level: smoothing leaves it alone; empty: none
};

struct FitOptions {
  /// Levels weigh as γ^(k - K) (eq. A.2): below 1 coarse levels rule and little is smoothed, above 1 fine ones.
  double gamma = 4;
  int smoothing_passes = 16;  ///< of Taubin's filter with each level's neighbours; 0 smooths nothing
  double reach_edges = 2;     ///< how far a level's details reach, in its mean edges
  /// Of bodies, whose least squares are iterated: gradient, relative to that at the start of the level, and steps.
  /// Levels of figures are solved to rounding; above 40,000 vertices they are iterated, too, to a hundredth.
  double tolerance = 1e-3;
  int most_iterations = 1000;
};

struct FittedMesh {
  SimplicialMesh mesh;  ///< finest level
  std::vector<FitLevelReport> levels;
};

/// A smooth interpolator (Ohbuchi, Kokojima & Takahashi 2001, Section 2.3 and Appendix A), level by level. Let f be the
/// total detail up to level k over the weight of these levels, that is, the surface itself. Equations A.6 to A.13 say:
/// f begins as the former level's, refined (A.13), and what is smoothed subject to the level's constraints is f less
/// the share 1 - ρ of that, ρ = β⁽ᵏ⁾ / (β⁽⁰⁾ + ... + β⁽ᵏ⁾). Here the share ρ of Taubin's filter is applied among
/// neighbours of one t, without shrinking what is smooth; and where sources or constraints want the surface elsewhere,
/// or the sequence has a kink at an inner t, the surroundings follow with the least bending. A vertex keeps its t,
/// half-way between the ends of the edge that it halves. The result does not depend on the number of threads.
///
/// Throws InputError for constraints that name levels or vertices which are not there.
FittedMesh fit_multiresolution(const FitProblem& problem, const FitOptions& options, const Progress& progress = {});

}  // namespace isostack
