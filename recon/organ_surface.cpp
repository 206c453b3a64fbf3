#include "recon/organ_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "recon/contour_fit.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/lost_contours.h"
#include "recon/section_repairs.h"
#include "recon/surface/cut_field.h"
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

namespace {

FittedOrgan fitted_organ(const ContourFit& fit, ImplicitFunction function, const ContourStack& contours) {
  const ContourConstraints& built = fit.constraints();
  FittedOrgan organ{.function = std::move(function), .poses = {}, .seeds_mm = {}};
  for (std::size_t i = 0; i < built.samples.size(); ++i)
    organ.seeds_mm.emplace_back(built.constraints.points.col(static_cast<Eigen::Index>(i)));
  organ.samples = built.samples;
  for (const ContourSlice& slice : contours.slices) {
    organ.add_plane(slice.pose);
    organ.slice_names.push_back(slice.name);
  }
  return organ;
}

}  // namespace

BoundedField bounded_field(const FittedOrgan& organ, const ReconstructOptions& options) {
  const auto values = [f = organ.function](const Eigen::MatrixXd& points) { return f.values(points); };
  const auto gradients = [f = organ.function](const Eigen::Matrix3Xd& points) -> Eigen::Matrix3Xd {
    return f.gradients(points);
  };
  BoundedField bounded{{values, gradients}, stack_bounds(organ.poses, organ.seeds_mm, values, options.caps)};
  if (!bounded.bounds.ends.empty()) bounded.field = extruded_beyond(bounded.field, bounded.bounds.ends);
  return bounded;
}

namespace {

constexpr int most_refinements = 2;
constexpr std::size_t most_vertices_to_refine = 1'000'000;  // a refined surface has four times as many

std::pair<ExtractedSurface, std::vector<LostContour>> extract_every_contour(const FittedOrgan& organ,
                                                                            const ScalarField& field,
                                                                            const ReconstructOptions& options,
                                                                            ExtractionOptions& extraction,
                                                                            const Progress& progress) {
  const int refinements = options.resolution_mm > 0 ? 0 : most_refinements;
  for (int refined = 0;; ++refined, extraction.resolution_mm /= 2) {
    try {
      ExtractedSurface extracted = extract_surface(field, organ.seeds_mm, extraction, progress);
      std::vector<LostContour> lost = lost_contours(organ, extracted.seeds_without_surface);
      if (options.resolution_mm <= 0) lost = add_lost_parts(lost, organ, field, extraction, extracted);
      const bool too_many = extracted.mesh.vertices_mm.size() >= most_vertices_to_refine;
      if (lost.empty() || refined == refinements || too_many) return {std::move(extracted), std::move(lost)};
    } catch (const GeometryError&) {  // every contour fits between the cells' corners
      if (refined == refinements) throw;
    }
  }
}

}  // namespace

std::vector<ContourSample> extract_organ(const FittedOrgan& organ, const BoundedField& bounded,
                                         const ReconstructOptions& options, const Progress& progress,
                                         Reconstruction& result) {
  const Stopwatch watch;
  const StackBounds& bounds = bounded.bounds;
  ExtractionOptions extraction;
  const double box_diagonal_mm = bounds.box.diagonal().norm();
  extraction.resolution_mm = options.resolution_mm > 0
                                 ? options.resolution_mm
                                 : std::max(organ.cell_pixels * organ.pixel_mm, box_diagonal_mm / 600);
  extraction.bounds = bounds.box;
  extraction.half_spaces = bounds.half_spaces;
  auto [extracted, lost] = extract_every_contour(organ, bounded.field, options, extraction, progress);
  result.surface =
      options.caps == Caps::open ? clipped(std::move(extracted.mesh), bounds.ends) : std::move(extracted.mesh);
  result.kept_points_mm = organ.seeds_mm;
  result.report.resolution_mm = extraction.resolution_mm;
  result.report.contour_points_without_surface = extracted.seeds_without_surface.size();
  result.report.open_end = bounds.open_end;
  result.report.cut_by_bounds = extracted.cut_by_bounds;
  result.report.surface_seconds += watch.seconds();
  result.report.peak_bytes = peak_memory_bytes();
  std::vector<ContourSample> lost_samples;
  for (const LostContour& contour : lost) lost_samples.push_back(organ.samples[contour.front()]);
  return lost_samples;
}

void require_none_lost(const std::vector<ContourSample>& lost, const FittedOrgan& organ,
                       const ReconstructOptions& options) {
  if (lost.empty() || options.accept_lost_contours) return;
  const ContourSample& first = lost.front();
  throw SolveError(
      organ.slice_names[first.slice],
      fmt::format("the surface misses its contour near ({:.1f}, {:.1f}) mm in the slice{}", first.point_in_slice_mm.x(),
                  first.point_in_slice_mm.y(), lost.size() > 1 ? fmt::format(" and {} others", lost.size() - 1) : ""),
      "give a finer --resolution, less --smoothing or more --max-constraints, or go on without them with "
      "--accept-residual");
}

namespace {

/// Where sections of a surface with cells of one pixel are farther than this from the contours, on average, the organ
/// has parts too thin or too curved for them.
constexpr double coarse_mean_pixels = 0.03;

}  // namespace

OrganSurface reconstruct_organ(const ContourStack& contours, const ReconstructOptions& options,
                               const Progress& progress) {
  require_two_slices(contours);
  Reconstruction result;
  ReconstructReport& report = result.report;
  const Stopwatch constraint_watch;
  ContourFit fit(contours, options, progress, report);
  report.contour_points = point_count(contours);
  report.constraint_seconds = constraint_watch.seconds();

  const Stopwatch solve_watch;
  std::optional<FittedOrgan> organ = fitted_organ(fit, fit.run(), contours);
  report.boundary_constraints = organ->samples.size();
  report.solve_seconds = solve_watch.seconds();
  BoundedField bounded = bounded_field(*organ, options);
  std::vector<ContourSample> lost = extract_organ(*organ, bounded, options, progress, result);

  // Chords of cells coarser than a pixel, which were asked for, are nothing to repair.
  const double asked_pixels = options.resolution_mm / organ->pixel_mm;
  const double tolerance_pixels =
      asked_pixels > 1 ? std::max(options.section_tolerance_pixels, asked_pixels) : options.section_tolerance_pixels;
  const bool sections_repairable = options.smoothing <= 0 && !options.tolerance_mm && options.caps != Caps::open;
  for (int round = 0; sections_repairable && round < options.section_rounds; ++round) {
    progress.report("sections", 0);
    const Stopwatch repair_watch;
    SectionDeviations deviations = section_deviations(result.surface, contours, tolerance_pixels);
    if (round == 0 && options.resolution_mm <= 0 && deviations.mean_pixels > coarse_mean_pixels) {
      organ->cell_pixels = 0.5;
      lost = extract_organ(*organ, bounded, options, progress, result);
      deviations = section_deviations(result.surface, contours, tolerance_pixels);
    }
    if (deviations.empty() || !fit.add(deviations, organ->function)) break;
    const double cell_pixels = organ->cell_pixels;
    bounded = {};
    organ.reset();  // the solve takes its memory
    organ = fitted_organ(fit, fit.run_again(), contours);
    organ->cell_pixels = cell_pixels;
    report.solve_seconds += repair_watch.seconds();
    bounded = bounded_field(*organ, options);
    lost = extract_organ(*organ, bounded, options, progress, result);
  }
  require_none_lost(lost, *organ, options);
  result.surface.name = contours.name;
  result.surface.color = contours.color;
  return {std::move(*organ), std::move(bounded), std::move(result)};
}

void retriangulate_organ(const BoundedField& bounded, const ReconstructOptions& options, const Progress& progress,
                         Reconstruction& result) {
  if (!options.retriangulation.any()) return;
  const Stopwatch watch;
  const FieldBounds bounds{bounded.bounds.box, bounded.bounds.half_spaces, 1e-3 * result.report.resolution_mm};
  const ScalarField field = cut_to_bounds(bounded.field, bounds);
  result.surface =
      retriangulate(result.surface, options.retriangulation, result.report.retriangulation.emplace(), &field, progress);
  result.report.surface_seconds += watch.seconds();
}

}  // namespace isostack
