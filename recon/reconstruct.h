#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recon/constraints/constraint_set.h"
#include "recon/constraints/crossings.h"
#include "recon/constraints/soften.h"
#include "recon/contour_residual.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/geometry/slice.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/kernels/kernel.h"
#include "recon/metrics/slice_agreement.h"
#include "recon/solvers/interpolation_solver.h"
#include "recon/surface/retriangulate.h"
#include "recon/surface/stack_bounds.h"

namespace isostack {

struct ReconstructOptions {
  Kernel kernel = triharmonic();
  double smoothing = 0;             ///< ρ of every constraint; 0 interpolates
  SofteningOptions softening = {};  ///< smoothing where crossing slices contradict each other; strength 0: none
  /// The smoothest surface within this distance of all contour points, by bisection of a smoothing common to all
  /// constraints. Without: `smoothing` as it is.
  std::optional<double> tolerance_mm = {};
  /// As few contour points as constraints as bring all within this distance of the surface; 0: as many as are allowed.
  double thin_mm = 0;
  double offset_pixels = 1;    ///< distance of the partners inside and outside the contour
  int solves = 5;              ///< solves that settle the oblique cuts; 1 leaves them uncorrected
  int plane_check_rounds = 6;  ///< repairs at most, after comparing f with the segmentation on every plane
  /// Sections of the surface by the input planes are repaired where they are farther than this from the contours there.
  double section_tolerance_pixels = 0.25;
  int section_rounds = 3;                         ///< of such repairs at most
  double sample_spacing_pixels = 0.5;             ///< nearer contour points are left out
  SolverChoice solver = SolverChoice::automatic;  ///< dense, fast, or whichever takes less time
  double solve_tolerance_pixels = 1e-3;           ///< largest residual of the fast solver
  bool accept_residual = false;                   ///< go on with the best solution when the solve stalls
  bool accept_lost_contours = false;              ///< go on when the surface misses a contour
  std::size_t max_constraints = 60'000;           ///< contours are thinned to this many
  /// Cell size of the surface; 0: a pixel, half of it for thin parts; at least diagonal / 600.
  double resolution_mm = 0;
  Caps caps = Caps::round;                      ///< how the surface ends beyond a parallel stack
  RetriangulationOptions retriangulation = {};  ///< of the extracted surface; by default it stays as extracted
  bool allow_overlap = false;  ///< reconstruct_all: leave surfaces of several organs as each is by itself
  std::size_t memory_limit_bytes = std::size_t{8} << 30;
};

/// The same, but passing through every constraint, also contradicting ones, and nearer to all contours: more points as
/// constraints, closer and more repairs of sections, no softening.
ReconstructOptions interpolating(ReconstructOptions options = {});

/// What was done, for reports.
struct ReconstructReport {
  std::size_t contour_points = 0;        ///< on all contours
  std::size_t boundary_constraints = 0;  ///< of those, kept
  std::size_t constraints = 0;           ///< solved for, at different points
  std::size_t merged_constraints = 0;    ///< left out because they coincide with another
  double largest_contradiction = 0;      ///< largest difference of values that were averaged by that
  Contradictions contradictions;         ///< between crossing slices, as they were given
  std::size_t softened_constraints = 0;  ///< given smoothing because of them
  std::size_t predicted_bytes = 0;       ///< of the solver, known before it starts
  int solves = 0;
  std::string solver;                    ///< "dense" or "fast"
  int iterations = 0, sweeps = 0;        ///< of the fast solver, all solves together
  double tolerance = 0;                  ///< residual asked for, mm
  double largest_residual = 0;           ///< of the system after the last solve, mm
  bool converged = true;                 ///< the last solve met the tolerance
  std::string residual_remark;           ///< where and why, when it did not
  std::vector<SolveStage> solve_stages;  ///< seconds of all solves together, largest bytes
  double resolution_mm = 0;
  std::size_t contour_points_without_surface = 0;
  std::size_t plane_points = 0;          ///< lattice points compared with the segmentation, all planes together
  std::size_t plane_points_wrong = 0;    ///< of those, more than a pixel on the wrong side of the result
  std::size_t between_points_wrong = 0;  ///< between slices: against both, or where both show a thin part
  std::size_t plane_constraints = 0;     ///< constraints added for them
  std::size_t section_constraints = 0;   ///< contour points and others added because sections strayed
  ContourResidual contour_residual;      ///< of all contour points, whether constraints or not
  SliceAgreement sections;               ///< cuts of the surface by all input planes against the contours there
  double smoothing = 0;                  ///< ρ that met the tolerance, or that was given
  std::optional<RetriangulationReport> retriangulation;  ///< when it was asked for
  std::vector<std::string> shares_faces_with;            ///< organs that had to be kept from overlapping this one
  bool open_end = false;       ///< the organ is cut by the end of the stack: the surface is flat there
  bool cut_by_bounds = false;  ///< flat there, or cut at the box round the contours
  double constraint_seconds = 0, solve_seconds = 0, surface_seconds = 0;
  std::size_t peak_bytes = 0;  ///< of the whole process
};

struct Reconstruction {
  TriangleMesh surface;
  std::vector<Eigen::Vector3d> kept_points_mm;  ///< the contour points that became boundary constraints
  ReconstructReport report;
};

/// One closed surface through all contours (Turk & O'Brien 1999, §6), with signed-distance
/// constraints in mm. Throws GeometryError for fewer than two slices with contours, SolveError
/// when the solve fails or does not fit.
Reconstruction reconstruct(const ContourStack& contours, const ReconstructOptions& options,
                           const Progress& progress = {});

/// The paper's own recipe (§4.1, §6), the preset `turk-obrien`: constraints from the crossings
/// between 4-neighbours of every image, value 1 at one pixel inwards along the gradient.
Reconstruction reconstruct_turk_obrien(const SliceStack& images, double level, const ReconstructOptions& options,
                                       const Progress& progress = {});

}  // namespace isostack
