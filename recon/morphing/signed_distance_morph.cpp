#include "recon/morphing/signed_distance_morph.h"

#include <utility>

#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"
#include "recon/morphing/distance_sections.h"

namespace isostack {

namespace {

bool are_figures(const std::vector<KeyShape>& shapes) { return dimension_of(shapes.front().shape) == 2; }

}  // namespace

DistanceWeights::DistanceWeights(KeyPlaces places, AlongNormal between)
    : places_(std::move(places)), between_(between) {
  if (places_.layout == KeyLayout::line)
    times_.assign(places_.coordinates.data(), places_.coordinates.data() + places_.coordinates.size());
}

Eigen::VectorXd DistanceWeights::at(const Eigen::VectorXd& weights) const {
  return places_.layout == KeyLayout::line ? along(places_.place_at(weights)[0]) : weights;
}

Eigen::VectorXd DistanceWeights::along(double coordinate) const { return weights_along(times_, coordinate, between_); }

Morph signed_distance_morph(const std::vector<KeyShape>& shapes, const SignedDistanceMorphOptions& options,
                            const Progress& progress) {
  require_morphable(shapes);
  require_distances(shapes);
  if (options.between == AlongNormal::cubic && options.layout != KeyLayout::line)
    throw InputError("morph", "a cubic spline runs along a line, not between corners",
                     "put the shapes on a line, or interpolate linearly");
  const KeyPlaces places = key_places(shapes, options.layout);
  const double side_mm = box_of(shapes).sizes().maxCoeff();
  const double fine_mm = are_figures(shapes) ? common_pose(shapes).spacing_mm.minCoeff() : 1e-2 * side_mm;
  MorphReport report;
  report.method = "signed-distance";
  report.spacing_mm = side_mm / 2;  // t has no length of its own here
  report.resolution_mm = options.resolution_mm > 0 ? options.resolution_mm : fine_mm;
  const Stopwatch watch;
  DistanceMorph morph{.shapes = shapes,
                      .weights = DistanceWeights(places, options.between),
                      .spacing_mm = report.spacing_mm,
                      .resolution_mm = report.resolution_mm};
  auto method = are_figures(shapes) ? figure_distances(std::move(morph))
                                    : body_distances(std::move(morph), options.memory_limit_bytes, progress);
  report.constraint_seconds = watch.seconds();
  return Morph(std::move(method), places, std::move(report));
}

}  // namespace isostack
