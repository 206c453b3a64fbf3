#include "recon/morphing/subdivision_morph.h"

#include <fmt/format.h>

#include <utility>

#include "recon/geometry/errors.h"
#include "recon/morphing/subdivision_bodies.h"
#include "recon/morphing/subdivision_figures.h"

namespace isostack {

namespace {

void require_options(const SubdivisionMorphOptions& options, int dimension) {
  constexpr int most_levels = 8;
  if (options.levels < 1 || options.levels > most_levels)
    throw InputError("levels", fmt::format("{} levels", options.levels), fmt::format("give 1 to {}", most_levels));
  if (!(options.gamma > 0)) throw InputError("gamma", fmt::format("{:g}", options.gamma), "give a number above 0");
  if (options.smoothing_passes < 0)
    throw InputError("smoothing", fmt::format("{} passes", options.smoothing_passes), "give 0 or more");
  if (options.spacing_mm && !(*options.spacing_mm > 0))
    throw InputError("spacing", fmt::format("{:g} mm", *options.spacing_mm), "give a length above 0");
  require_warp(options.warp, dimension);
}

void sum_up_levels(MorphReport& report) {
  report.solve.solver = "conjugate gradients, level by level";
  for (const FitLevelReport& level : report.levels) {
    report.solve.iterations += level.iterations;
    report.solve.converged = report.solve.converged && level.converged;
    report.solve.largest_residual = level.residual_mm;
  }
}

}  // namespace

Morph subdivision_morph(const std::vector<KeyShape>& shapes, const SubdivisionMorphOptions& options,
                        const Progress& progress) {
  require_morphable(shapes);
  require_options(options, dimension_of(shapes.front().shape));
  KeyPlaces places = key_places(shapes, KeyLayout::line);
  MorphReport report;
  report.method = "subdivision";
  report.spacing_mm = options.spacing_mm.value_or(box_of(shapes).sizes().maxCoeff() / 2);
  const auto make_method = dimension_of(shapes.front().shape) == 2 ? subdivided_figures : subdivided_bodies;
  std::unique_ptr<MorphMethod> method = make_method(shapes, options, places, report.spacing_mm, report, progress);
  sum_up_levels(report);
  return Morph(std::move(method), std::move(places), std::move(report));
}

}  // namespace isostack
