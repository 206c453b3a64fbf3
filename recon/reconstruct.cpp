#include "recon/reconstruct.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "recon/constraints/image_constraints.h"
#include "recon/contour_fit.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/solve_steps.h"
#include "recon/solvers/interpolation_solver.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/implicit_function.h"
#include "recon/surface/stack_bounds.h"

namespace isostack {

namespace {

std::vector<Eigen::Vector3d> leading_points(const ConstraintSet& set, Eigen::Index count) {
  std::vector<Eigen::Vector3d> points;
  for (Eigen::Index i = 0; i < count; ++i) points.emplace_back(set.points.col(i));
  return points;
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
  result.report.peak_bytes = peak_memory_bytes();
}

void require_two_slices(std::size_t with_boundary, std::size_t total, const std::string& name) {
  if (with_boundary >= 2) return;
  throw GeometryError(
      name.empty() ? "contours" : name,
      fmt::format("{} of {} slices have a contour, and a surface needs at least two", with_boundary, total),
      "give more slices, or check the level or label");
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
  ContourFit fit(contours, options, progress, report);
  const ContourConstraints& built = fit.constraints();
  report.contour_points = point_count(contours);
  report.boundary_constraints = built.samples.size();
  report.constraint_seconds = constraint_watch.seconds();

  const Stopwatch solve_watch;
  const ImplicitFunction function = fit.run();
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
