#include "recon/morphing/subdivision_bodies.h"

#include <fmt/format.h>

#include <utility>

#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"
#include "recon/morphing/body_features.h"
#include "recon/morphing/interpolator_sections.h"
#include "recon/subdivision/body_interpolator.h"
#include "recon/subdivision/fit_guides.h"
#include "recon/subdivision/simplex_section.h"
#include "recon/subdivision/source_vertices.h"

namespace isostack {

namespace {

constexpr std::size_t most_corners = 24;  // of a body that become base vertices

/// The optimised interpolator and how its sections become frames.
class SubdividedBodies : public InterpolatorSections {
 public:
  SubdividedBodies(SimplicialMesh mesh, const std::vector<KeyShape>& shapes, Eigen::RowVectorXd key_times_mm,
                   const TimeWarp& warp)
      : InterpolatorSections(std::move(mesh), std::move(key_times_mm), box_of(shapes), warp) {}

 private:
  Shape section(const Eigen::VectorXd& values, OnSection on) const override {
    TriangleMesh frame = section_mesh(mesh(), values, on);
    frame.name = "frame";
    return frame;
  }
};

/// All that leads from key shapes to the interpolator.
class BodyMaker {
 public:
  BodyMaker(const std::vector<KeyShape>& shapes, const SubdivisionMorphOptions& options,
            Eigen::RowVectorXd key_times_mm)
      : options_(options), times_mm_(std::move(key_times_mm)) {
    if (!options.key_shapes.empty())
      throw InputError(options.key_shapes.front().name.empty() ? "key shape" : options.key_shapes.front().name,
                       "topological key shapes are for figures", "leave it out: bodies keep their genus");
    std::vector<TriangleMesh> bodies;
    for (const KeyShape& shape : shapes) {
      bodies.push_back(std::get<TriangleMesh>(shape.shape));
      bodies.back().name = shape.name.empty() ? "shape" : shape.name;
    }
    features_ = features_in(bodies, options.features);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      how_.kept.push_back(options.sharp_angle_rad ? sharp_corners(bodies[i], *options.sharp_angle_rad, most_corners)
                                                  : std::vector<int>{});
      layers_.push_back({times_mm_[static_cast<Eigen::Index>(i)], std::move(bodies[i])});
    }
    how_.levels = options.levels;
    how_.features = features_.pairs;
  }

  /// With all vertices of the bodies.
  SimplicialMesh fitted(MorphReport& report, const Progress& progress) {
    progress.report("mesh", 0);
    const BodyInterpolator bodies = body_interpolator(layers_, how_, progress);
    FitProblem problem = fit_problem(bodies, options_.details == DetailsBetween::linger);
    report.constraints = problem.held.back().vertices.size();
    for (std::size_t i = 0; i < features_.order.size(); ++i)
      add_line(problem, feature_line(options_.features[features_.order[i]], bodies.features[i]));
    for (const EnhancedTransition& transition : options_.transitions) add_transition(transition, problem);
    FittedMesh fitted = fit_multiresolution(
        problem, {.gamma = options_.gamma, .smoothing_passes = options_.smoothing_passes}, progress);
    report.levels = fitted.levels;
    progress.report("key shapes", 0);
    return with_source_vertices(fitted.mesh, bodies, problem.levels);
  }

 private:
  double time_mm(double share) const { return times_mm_[0] + share * (times_mm_[times_mm_.size() - 1] - times_mm_[0]); }

  Eigen::Vector4d place_in_time(const TimedPlace& place, const std::string& where) const {
    if (place.place_mm.size() != 3 || !place.place_mm.allFinite())
      throw InputError(where, "a place has not three coordinates", "give x, y and z in mm");
    return {place.place_mm[0], place.place_mm[1], place.place_mm[2], time_mm(place.t)};
  }

  FeatureLine feature_line(const CorrespondingPoints& feature, const std::array<int, 2>& ends) const {
    FeatureLine line{.ends = ends, .by_way_of = {}, .sharp = feature.sharp};
    line.by_way_of.resize(4, static_cast<Eigen::Index>(feature.by_way_of.size()));
    for (std::size_t i = 0; i < feature.by_way_of.size(); ++i)
      line.by_way_of.col(static_cast<Eigen::Index>(i)) = place_in_time(feature.by_way_of[i], "feature");
    return line;
  }

  void add_transition(const EnhancedTransition& transition, FitProblem& problem) const {
    if (transition.level < 1 || transition.level > options_.levels)
      throw InputError("transition", fmt::format("level {} of {}", transition.level, options_.levels),
                       "give a level from 1 to that of --levels");
    if (!(transition.at.t > 0 && transition.at.t < 1) || transition.to_mm.size() != 3)
      throw InputError("transition", "it is not at a time between 0 and 1 with places of three coordinates",
                       "give t, from_mm and to_mm");
    add_pull(problem, transition.level, place_in_time(transition.at, "transition"), transition.to_mm);
  }

  const SubdivisionMorphOptions& options_;
  Eigen::RowVectorXd times_mm_;
  std::vector<BodyLayer> layers_;
  BodyFeatures features_;
  BodyInterpolatorOptions how_;
};

}  // namespace

std::unique_ptr<MorphMethod> subdivided_bodies(const std::vector<KeyShape>& shapes,
                                               const SubdivisionMorphOptions& options, const KeyPlaces& places,
                                               double spacing_mm, MorphReport& report, const Progress& progress) {
  const Eigen::RowVectorXd key_times_mm = spacing_mm * places.coordinates.row(0);
  BodyMaker maker(shapes, options, key_times_mm);
  const Stopwatch watch;
  SimplicialMesh mesh = maker.fitted(report, progress);
  report.solve_seconds = watch.seconds();
  return std::make_unique<SubdividedBodies>(std::move(mesh), shapes, key_times_mm, options.warp);
}

}  // namespace isostack
