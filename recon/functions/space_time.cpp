#include "recon/functions/space_time.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "recon/functions/r_functions.h"
#include "recon/geometry/errors.h"

namespace isostack {

SolidFunction cylinder(SolidFunction solid) {
  return [solid = std::move(solid)](const Eigen::MatrixXd& points) { return solid(points.topRows(points.rows() - 1)); };
}

SolidFunction times_from(double from_mm) {
  return [from_mm](const Eigen::MatrixXd& points) -> Eigen::ArrayXd {
    return points.bottomRows<1>().transpose().array() - from_mm;
  };
}

SolidFunction times_until(double to_mm) {
  return [to_mm](const Eigen::MatrixXd& points) -> Eigen::ArrayXd {
    return to_mm - points.bottomRows<1>().transpose().array();
  };
}

SolidFunction time_slab(const TimeSpan& span_mm) {
  return r_intersection(times_from(span_mm.from), times_until(span_mm.to));
}

SolidFunction cross_section(SolidFunction solid, double time_mm) {
  return [solid = std::move(solid), time_mm](const Eigen::MatrixXd& points) {
    Eigen::MatrixXd placed(points.rows() + 1, points.cols());
    placed.topRows(points.rows()) = points;
    placed.bottomRows<1>().setConstant(time_mm);
    return solid(placed);
  };
}

namespace {

void require_cover(const SpaceTimeBlend& blend) {
  const TimeSpan &gap = blend.gap_mm, &slab = blend.slab_mm;
  if (!(gap.from <= gap.to)) throw InputError("blend", "the gap ends before it begins", "give a later end");
  if (!(std::isfinite(slab.from) && std::isfinite(slab.to) && slab.from < gap.from && gap.to < slab.to))
    throw InputError("blend",
                     fmt::format("the bounding slab from {:.4g} to {:.4g} mm does not cover the gap from {:.4g} to "
                                 "{:.4g} mm between the half-cylinders",
                                 slab.from, slab.to, gap.from, gap.to),
                     "let it begin before the gap and end after it");
  // Rounding of spans that were computed is no reason to refuse them.
  const double spare_mm = 1e-9 * (slab.to - slab.from);
  const auto require_reach = [&](const std::optional<HalfCylinderSmoothing>& smoothing, double most_mm) {
    if (smoothing && !(smoothing->reach_mm > 0 && smoothing->reach_mm <= most_mm + spare_mm))
      throw InputError("blend",
                       fmt::format("a half-cylinder is smoothed up to {:.4g} mm from its end, the blend's bounding "
                                   "slab ends {:.4g} mm from there",
                                   smoothing->reach_mm, most_mm),
                       "smooth within the slab");
  };
  require_reach(blend.first, gap.from - slab.from);
  require_reach(blend.second, slab.to - gap.to);
}

/// What remains of a cylinder when the half-space that begins or ends at `end_mm` is taken away.
SolidFunction half_cylinder(SolidFunction cylinder, SolidFunction half_space, double end_mm,
                            const std::optional<HalfCylinderSmoothing>& smoothing) {
  if (!smoothing) return r_subtraction(std::move(cylinder), std::move(half_space));
  const TimeSpan bounds{.from = end_mm - smoothing->reach_mm, .to = end_mm + smoothing->reach_mm};
  return bounded_blend_subtraction(std::move(cylinder), std::move(half_space), time_slab(bounds), smoothing->blend);
}

}  // namespace

SolidFunction space_time_blend(SolidFunction first_cylinder, SolidFunction second_cylinder,
                               const SpaceTimeBlend& blend) {
  require_cover(blend);
  SolidFunction bounds = time_slab(blend.slab_mm);
  if (blend.bounds) bounds = r_intersection(bounds, blend.bounds);
  return bounded_blend_union(
      half_cylinder(std::move(first_cylinder), times_from(blend.gap_mm.from), blend.gap_mm.from, blend.first),
      half_cylinder(std::move(second_cylinder), times_until(blend.gap_mm.to), blend.gap_mm.to, blend.second),
      std::move(bounds), blend.blend);
}

}  // namespace isostack
