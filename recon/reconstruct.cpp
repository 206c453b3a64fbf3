#include "recon/reconstruct.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "recon/constraints/contour_constraints.h"
#include "recon/constraints/image_constraints.h"
#include "recon/geometry/errors.h"
#include "recon/solvers/dense_solver.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/implicit_function.h"

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

DenseSolver make_solver(const ConstraintSet& set, const ReconstructOptions& options, const Progress& progress) {
  Eigen::VectorXd smoothing;
  if (options.smoothing > 0) smoothing = Eigen::VectorXd::Constant(set.values.size(), options.smoothing);
  return DenseSolver(options.kernel, set.points, smoothing, {.memory_limit_bytes = options.memory_limit_bytes},
                     progress);
}

/// The largest distance between consecutive planes along each slice's normal: how far the surface
/// may reach beyond the contours.
double reach_beyond_contours_mm(const std::vector<SlicePose>& poses, const Eigen::AlignedBox3d& contours_box) {
  double reach = 0.1 * contours_box.diagonal().norm();
  for (const SlicePose& pose : poses) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const SlicePose& other : poses) {
      const double distance = std::abs(pose.signed_distance_mm(other.origin_mm));
      if (distance > 1e-6 && are_parallel(pose, other)) nearest = std::min(nearest, distance);
    }
    if (std::isfinite(nearest)) reach = std::max(reach, 1.5 * nearest);
  }
  return reach;
}

struct SurfaceRequest {
  std::vector<SlicePose> poses;
  double pixel_mm;
  std::vector<Eigen::Vector3d> seeds_mm;
};

void extract(const ImplicitFunction& function, const SurfaceRequest& request, const ReconstructOptions& options,
             const Progress& progress, Reconstruction& result) {
  const Stopwatch watch;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& seed : request.seeds_mm) box.extend(seed);
  const double reach = reach_beyond_contours_mm(request.poses, box);
  ExtractionOptions extraction;
  extraction.resolution_mm =
      options.resolution_mm > 0 ? options.resolution_mm : std::max(request.pixel_mm, box.diagonal().norm() / 400);
  extraction.bounds =
      Eigen::AlignedBox3d(box.min() - Eigen::Vector3d::Constant(reach), box.max() + Eigen::Vector3d::Constant(reach));
  const ScalarField field{
      [&](const Eigen::Matrix3Xd& points) { return function.values(points); },
      [&](const Eigen::Matrix3Xd& points) -> Eigen::Matrix3Xd { return function.gradients(points); }};
  ExtractedSurface extracted = extract_surface(field, request.seeds_mm, extraction, progress);
  result.surface = std::move(extracted.mesh);
  result.kept_points_mm = request.seeds_mm;
  result.report.resolution_mm = extraction.resolution_mm;
  result.report.contour_points_without_surface = extracted.seeds_without_surface;
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

double largest_residual(const ImplicitFunction& function, const ConstraintSet& set) {
  return (function.values(set.points) - set.values).cwiseAbs().maxCoeff();
}

}  // namespace

Reconstruction reconstruct(const ContourStack& contours, const ReconstructOptions& options, const Progress& progress) {
  const auto has_contour = [](const ContourSlice& slice) { return !slice.contours.empty(); };
  require_two_slices(
      static_cast<std::size_t>(std::count_if(contours.slices.begin(), contours.slices.end(), has_contour)),
      contours.slices.size(), contours.name);
  Reconstruction result;
  const Stopwatch constraint_watch;
  ContourConstraints built =
      signed_constraints(contours, sample_contours(contours, {.max_samples = options.max_constraints / 3}),
                         {.offset_pixels = options.offset_pixels});
  const auto sample_count = static_cast<Eigen::Index>(built.samples.size());
  result.report.contour_points = point_count(contours);
  result.report.boundary_constraints = built.samples.size();
  result.report.constraints = static_cast<std::size_t>(built.constraints.values.size());
  result.report.solver_bytes = DenseSolver::required_bytes(result.report.constraints);
  result.report.constraint_seconds = constraint_watch.seconds();

  const Stopwatch solve_watch;
  const DenseSolver solver = make_solver(built.constraints, options, progress);
  const Eigen::MatrixXd boundary = built.constraints.points.leftCols(sample_count);
  const auto solve = [&] {
    ++result.report.solves;
    return ImplicitFunction(options.kernel, built.constraints.points, solver.solve(built.constraints.values));
  };
  ImplicitFunction function = solve();
  while (result.report.solves < options.solves) {
    progress.report("normals", static_cast<double>(result.report.solves) / options.solves);
    correct_for_oblique_cuts(function.gradients(boundary), contours, built);
    function = solve();
  }
  if (options.smoothing == 0) result.report.largest_residual = largest_residual(function, built.constraints);
  result.report.solve_seconds = solve_watch.seconds();

  SurfaceRequest request{{}, std::numeric_limits<double>::infinity(), leading_points(built.constraints, sample_count)};
  for (const ContourSlice& slice : contours.slices) {
    request.poses.push_back(slice.pose);
    request.pixel_mm = std::min(request.pixel_mm, slice.pose.spacing_mm.minCoeff());
  }
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
  result.report.constraints = static_cast<std::size_t>(set.values.size());
  result.report.solver_bytes = DenseSolver::required_bytes(result.report.constraints);
  result.report.constraint_seconds = constraint_watch.seconds();
  require_two_slices(pairs > 0 ? images.slices.size() : 0, images.slices.size(), images.name);

  const Stopwatch solve_watch;
  const ImplicitFunction function(options.kernel, set.points, make_solver(set, options, progress).solve(set.values));
  result.report.solves = 1;
  if (options.smoothing == 0) result.report.largest_residual = largest_residual(function, set);
  result.report.solve_seconds = solve_watch.seconds();

  SurfaceRequest request{{}, std::numeric_limits<double>::infinity(), leading_points(set, pairs)};
  for (const Slice& slice : images.slices) {
    request.poses.push_back(slice.pose);
    request.pixel_mm = std::min(request.pixel_mm, slice.pose.spacing_mm.minCoeff());
  }
  extract(function, request, options, progress, result);
  result.surface.name = images.name;
  return result;
}

}  // namespace isostack
