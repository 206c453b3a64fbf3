#include "recon/organ_surface.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/contour_fit.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/stack_caps.h"

namespace isostack {

void require_two_slices(std::size_t with_boundary, std::size_t total, const std::string& name) {
  if (with_boundary >= 2) return;
  throw GeometryError(
      name.empty() ? "contours" : name,
      fmt::format("{} of {} slices have a contour, and a surface needs at least two", with_boundary, total),
      "give more slices, or check the level or label");
}

void require_two_slices(const ContourStack& contours) {
  const auto has_contour = [](const ContourSlice& slice) { return !slice.contours.empty(); };
  require_two_slices(
      static_cast<std::size_t>(std::count_if(contours.slices.begin(), contours.slices.end(), has_contour)),
      contours.slices.size(), contours.name);
}

void FittedOrgan::add_plane(const SlicePose& pose) {
  poses.push_back(pose);
  pixel_mm = std::min(pixel_mm, pose.spacing_mm.minCoeff());
}

FittedOrgan fit_organ(const ContourStack& contours, const ReconstructOptions& options, const Progress& progress,
                      ReconstructReport& report) {
  const Stopwatch constraint_watch;
  ContourFit fit(contours, options, progress, report);
  const ContourConstraints& built = fit.constraints();
  report.contour_points = point_count(contours);
  report.constraint_seconds = constraint_watch.seconds();

  const Stopwatch solve_watch;
  FittedOrgan organ{.function = fit.run(), .poses = {}, .seeds_mm = {}};
  report.boundary_constraints = built.samples.size();
  report.solve_seconds = solve_watch.seconds();

  for (std::size_t i = 0; i < built.samples.size(); ++i)
    organ.seeds_mm.emplace_back(built.constraints.points.col(static_cast<Eigen::Index>(i)));
  for (const ContourSlice& slice : contours.slices) organ.add_plane(slice.pose);
  return organ;
}

BoundedField bounded_field(const FittedOrgan& organ, const ReconstructOptions& options) {
  const auto values = [f = organ.function](const Eigen::MatrixXd& points) { return f.values(points); };
  const auto gradients = [f = organ.function](const Eigen::Matrix3Xd& points) -> Eigen::Matrix3Xd {
    return f.gradients(points);
  };
  BoundedField bounded{{values, gradients}, stack_bounds(organ.poses, organ.seeds_mm, values, options.caps)};
  if (!bounded.bounds.ends.empty()) bounded.field = extruded_beyond(bounded.field, bounded.bounds.ends);
  return bounded;
}

void extract_organ(const FittedOrgan& organ, const BoundedField& bounded, const ReconstructOptions& options,
                   const Progress& progress, Reconstruction& result) {
  const Stopwatch watch;
  const StackBounds& bounds = bounded.bounds;
  ExtractionOptions extraction;
  const double box_diagonal_mm = bounds.box.diagonal().norm();
  extraction.resolution_mm =
      options.resolution_mm > 0 ? options.resolution_mm : std::max(organ.pixel_mm, box_diagonal_mm / 600);
  extraction.bounds = bounds.box;
  extraction.half_spaces = bounds.half_spaces;
  ExtractedSurface extracted = extract_surface(bounded.field, organ.seeds_mm, extraction, progress);
  result.surface =
      options.caps == Caps::open ? clipped(std::move(extracted.mesh), bounds.ends) : std::move(extracted.mesh);
  result.kept_points_mm = organ.seeds_mm;
  result.report.resolution_mm = extraction.resolution_mm;
  result.report.contour_points_without_surface = extracted.seeds_without_surface;
  result.report.open_end = bounds.open_end;
  result.report.cut_by_bounds = extracted.cut_by_bounds;
  result.report.surface_seconds += watch.seconds();
  result.report.peak_bytes = peak_memory_bytes();
}

}  // namespace isostack
