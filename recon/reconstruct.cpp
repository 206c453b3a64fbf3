#include "recon/reconstruct.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "recon/constraints/contour_constraints.h"
#include "recon/constraints/image_constraints.h"
#include "recon/constraints/plane_check.h"
#include "recon/geometry/errors.h"
#include "recon/solvers/interpolation_solver.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/implicit_function.h"
#include "recon/surface/stack_bounds.h"

namespace isostack {

namespace {

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::vector<Eigen::Vector3d> leading_points(const ConstraintSet& set, Eigen::Index count) {
  std::vector<Eigen::Vector3d> points;
  for (Eigen::Index i = 0; i < count; ++i) points.emplace_back(set.points.col(i));
  return points;
}

InterpolationOptions interpolation_options(const ReconstructOptions& options, double pixel_mm) {
  return {.kernel = options.kernel,
          .solver = options.solver,
          .tolerance = options.solve_tolerance_pixels * pixel_mm,
          .merge_distance = 0.01 * pixel_mm,  // no contour knows its place better than that
          .memory_limit_bytes = options.memory_limit_bytes};
}

/// The constraints with the same smoothing for each.
ConstraintSet with_smoothing(ConstraintSet set, double smoothing) {
  if (smoothing > 0) set.smoothing = Eigen::VectorXd::Constant(set.values.size(), smoothing);
  return set;
}

void describe(const InterpolationSolver& solver, std::size_t given, ReconstructReport& report) {
  report.constraints = static_cast<std::size_t>(solver.merged().set.values.size());
  report.merged_constraints = given - report.constraints;
  report.largest_contradiction = solver.merged().largest_contradiction;
  report.solver_bytes = solver.predicted_bytes();
}

void describe(const SolveReport& solve, const std::string& name, const ReconstructOptions& options,
              ReconstructReport& report) {
  report.solver = solve.solver;
  report.iterations += solve.iterations;
  report.largest_residual = solve.largest_residual;
  if (!solve.converged && !options.accept_residual)
    throw SolveError(
        name.empty() ? "solve" : name,
        fmt::format("the solve stalled at a residual of {:.2g} mm: {}", solve.largest_residual, solve.remark),
        "accept it with --accept-residual, add --smoothing, or use fewer constraints");
}

struct SurfaceRequest {
  std::vector<SlicePose> poses;
  double pixel_mm = std::numeric_limits<double>::infinity();
  std::vector<Eigen::Vector3d> seeds_mm;

  void add_plane(const SlicePose& pose) {
    poses.push_back(pose);
    pixel_mm = std::min(pixel_mm, pose.spacing_mm.minCoeff());
  }
};

void extract(const ImplicitFunction& function, const SurfaceRequest& request, const ReconstructOptions& options,
             const Progress& progress, Reconstruction& result) {
  const Stopwatch watch;
  const auto values = [&](const Eigen::MatrixXd& points) { return function.values(points); };
  const StackBounds bounds = stack_bounds(request.poses, request.seeds_mm, values);
  ExtractionOptions extraction;
  const double box_diagonal_mm = bounds.box.diagonal().norm();
  extraction.resolution_mm =
      options.resolution_mm > 0 ? options.resolution_mm : std::max(request.pixel_mm, box_diagonal_mm / 600);
  extraction.bounds = bounds.box;
  extraction.half_spaces = bounds.half_spaces;
  const ScalarField field{
      values, [&](const Eigen::Matrix3Xd& points) -> Eigen::Matrix3Xd { return function.gradients(points); }};
  ExtractedSurface extracted = extract_surface(field, request.seeds_mm, extraction, progress);
  result.surface = std::move(extracted.mesh);
  result.kept_points_mm = request.seeds_mm;
  result.report.resolution_mm = extraction.resolution_mm;
  result.report.contour_points_without_surface = extracted.seeds_without_surface;
  result.report.open_end = bounds.open_end;
  result.report.cut_by_bounds = extracted.cut_by_bounds;
  result.report.surface_seconds = watch.seconds();
}

void require_two_slices(std::size_t with_boundary, std::size_t total, const std::string& name) {
  if (with_boundary >= 2) return;
  throw GeometryError(
      name.empty() ? "contours" : name,
      fmt::format("{} of {} slices have a contour, and a surface needs at least two", with_boundary, total),
      "give more slices, or check the level or label");
}

double pixel_mm_of(const ContourStack& contours) {
  double pixel_mm = std::numeric_limits<double>::infinity();
  for (const ContourSlice& slice : contours.slices) pixel_mm = std::min(pixel_mm, slice.pose.spacing_mm.minCoeff());
  return pixel_mm;
}

/// Solves for the constraints as they are, then again with the partners' values corrected by the
/// normals found, `solves` times in all. Only values change: one solver serves all solves.
/// `weights` are those of an earlier fit to the leading constraints (or empty) and become this one's.
ImplicitFunction fit(ContourConstraints& built, const ContourStack& contours, const ReconstructOptions& options,
                     int solves, const Progress& progress, Eigen::VectorXd& weights, ReconstructReport& report) {
  const double pixel_mm = pixel_mm_of(contours);
  InterpolationSolver solver(with_smoothing(built.constraints, options.smoothing),
                             interpolation_options(options, pixel_mm), progress);
  describe(solver, static_cast<std::size_t>(built.constraints.values.size()), report);
  const Eigen::MatrixXd boundary = built.constraints.points.leftCols(static_cast<Eigen::Index>(built.samples.size()));
  const auto solve = [&] {
    ++report.solves;
    SolveReport reached;
    const RadialWeights solution = solver.solve(built.constraints.values, weights, reached, progress);
    describe(reached, contours.name, options, report);
    weights = solution.weights;
    return ImplicitFunction(options.kernel, solver.merged().set.points, solution,
                            options.solve_tolerance_pixels * pixel_mm);
  };
  ImplicitFunction function = solve();
  for (int done = 1; done < solves; ++done) {
    progress.report("normals", static_cast<double>(done) / solves);
    correct_for_oblique_cuts(function.gradients(boundary), contours, built);
    function = solve();
  }
  return function;
}

/// Adds what the planes object to; false when they all agree.
bool add_disagreements(const ImplicitFunction& function, const ContourStack& contours, const Progress& progress,
                       ContourConstraints& built, ReconstructReport& report) {
  progress.report("planes", 0);
  const PlaneCheck check =
      check_planes([&](const Eigen::MatrixXd& points) { return function.values(points); }, contours);
  report.plane_points = check.points;
  report.plane_points_wrong = check.wrong;
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<double> values_mm;
  for (const Disagreement& d : check.worst) {
    points_mm.push_back(d.point_mm);
    values_mm.push_back(d.distance_mm);
  }
  add_points(points_mm, values_mm, built);
  report.plane_constraints += points_mm.size();
  return !check.worst.empty();
}

}  // namespace

Reconstruction reconstruct(const ContourStack& contours, const ReconstructOptions& options, const Progress& progress) {
  const auto has_contour = [](const ContourSlice& slice) { return !slice.contours.empty(); };
  require_two_slices(
      static_cast<std::size_t>(std::count_if(contours.slices.begin(), contours.slices.end(), has_contour)),
      contours.slices.size(), contours.name);
  Reconstruction result;
  ReconstructReport& report = result.report;
  const Stopwatch constraint_watch;
  ContourConstraints built =
      signed_constraints(contours, sample_contours(contours, {.max_samples = options.max_constraints / 3}),
                         {.offset_pixels = options.offset_pixels});
  report.contour_points = point_count(contours);
  report.boundary_constraints = built.samples.size();
  report.constraint_seconds = constraint_watch.seconds();

  const Stopwatch solve_watch;
  Eigen::VectorXd weights;
  ImplicitFunction function = fit(built, contours, options, options.solves, progress, weights, report);
  for (int round = 0; round < options.plane_check_rounds; ++round) {
    if (!add_disagreements(function, contours, progress, built, report)) break;
    function = fit(built, contours, options, std::min(options.solves, 3), progress, weights, report);
  }
  report.solve_seconds = solve_watch.seconds();

  SurfaceRequest request;
  request.seeds_mm = leading_points(built.constraints, static_cast<Eigen::Index>(built.samples.size()));
  for (const ContourSlice& slice : contours.slices) request.add_plane(slice.pose);
  extract(function, request, options, progress, result);
  result.surface.name = contours.name;
  return result;
}

Reconstruction reconstruct_turk_obrien(const SliceStack& images, double level, const ReconstructOptions& options,
                                       const Progress& progress) {
  Reconstruction result;
  const Stopwatch constraint_watch;
  const ConstraintSet set = image_constraint_set(images, level, options.max_constraints);
  const ConstraintSet all = image_constraint_set(images, level, std::numeric_limits<std::size_t>::max());
  const Eigen::Index pairs = set.values.size() / 2;
  result.report.contour_points = static_cast<std::size_t>(all.values.size() / 2);
  result.report.boundary_constraints = static_cast<std::size_t>(pairs);
  result.report.constraint_seconds = constraint_watch.seconds();
  require_two_slices(pairs > 0 ? images.slices.size() : 0, images.slices.size(), images.name);

  const Stopwatch solve_watch;
  const double pixel_mm = images.slices.front().pose.spacing_mm.minCoeff();
  InterpolationSolver solver(with_smoothing(set, options.smoothing), interpolation_options(options, pixel_mm),
                             progress);
  describe(solver, static_cast<std::size_t>(set.values.size()), result.report);
  SolveReport reached;
  const RadialWeights solution = solver.solve(set.values, {}, reached, progress);
  describe(reached, images.name, options, result.report);
  const ImplicitFunction function(options.kernel, solver.merged().set.points, solution,
                                  options.solve_tolerance_pixels * pixel_mm);
  result.report.solves = 1;
  result.report.solve_seconds = solve_watch.seconds();

  SurfaceRequest request;
  request.seeds_mm = leading_points(set, pairs);
  for (const Slice& slice : images.slices) request.add_plane(slice.pose);
  extract(function, request, options, progress, result);
  result.surface.name = images.name;
  return result;
}

}  // namespace isostack
