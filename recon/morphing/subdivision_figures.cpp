#include "recon/morphing/subdivision_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "recon/geometry/errors.h"
#include "recon/geometry/pixel_lattice.h"
#include "recon/geometry/stopwatch.h"
#include "recon/morphing/figure_features.h"
#include "recon/morphing/interpolator_sections.h"
#include "recon/subdivision/figure_fit.h"
#include "recon/subdivision/fit_guides.h"
#include "recon/subdivision/simplex_section.h"

namespace isostack {

namespace {

/// The optimised interpolator and how its sections become frames.
class SubdividedFigures : public InterpolatorSections {
 public:
  SubdividedFigures(SimplicialMesh mesh, const std::vector<KeyShape>& shapes, Eigen::RowVectorXd key_times_mm,
                    const TimeWarp& warp)
      : InterpolatorSections(std::move(mesh), std::move(key_times_mm), box_of(shapes), warp),
        pose_(common_pose(shapes)),
        size_pixels_(std::get<ContourSlice>(shapes.front().shape).size_pixels) {}

  std::optional<TriangleMesh> spacetime_mesh() const override {
    TriangleMesh result{.name = "spacetime", .vertices_mm = {}, .triangles = {}, .normals = {}};
    for (Eigen::Index v = 0; v < mesh().vertex_count(); ++v)
      result.vertices_mm.emplace_back(mesh().vertices(0, v), mesh().vertices(1, v), shown_mm(v));
    for (Eigen::Index s = 0; s < mesh().simplex_count(); ++s) result.triangles.emplace_back(mesh().simplices.col(s));
    return result;
  }

 private:
  Shape section(const Eigen::VectorXd& values, OnSection on) const override {
    return ContourSlice{
        .name = "frame", .pose = pose_, .size_pixels = size_pixels_, .contours = section_contours(mesh(), values, on)};
  }

  SlicePose pose_;
  Eigen::Vector2i size_pixels_;
};

/// All that leads from key shapes to the interpolator.
class FigureMaker {
 public:
  FigureMaker(const std::vector<KeyShape>& shapes, const SubdivisionMorphOptions& options,
              Eigen::RowVectorXd key_times_mm)
      : shapes_(shapes), options_(options), times_mm_(std::move(key_times_mm)) {
    const SlicePose pose = common_pose(shapes);
    for (const KeyShape& shape : shapes) {
      const auto& figure = std::get<ContourSlice>(shape.shape);
      NamedFigure named{.name = shape.name.empty() ? "shape" : shape.name,
                        .contours = moved_to(pose, figure.contours, figure.pose)};
      std::erase_if(named.contours, [](const Contour& c) { return c.points_mm.size() < 3 || signed_area_mm2(c) == 0; });
      orient_by_nesting(named.contours);
      require_no_crossing(named);
      figures_.push_back(std::move(named));
    }
    points_ = features_in(figures_, options.features);
  }

  FittedMesh fitted(MorphReport& report, const Progress& progress) {
    make_layers();
    FigureInterpolatorOptions how;
    how.contours.levels = options_.levels;
    how.contours.tolerance_mm = options_.tolerance_share * box_of(shapes_).diagonal().norm();
    how.contours.sharp_angle_rad = options_.sharp_angle_rad;
    how.features = points_;
    progress.report("mesh", 0);
    const FigureInterpolator figures = figure_interpolator(layers_, how);
    FitProblem problem = figure_problem(figures, options_.levels, options_.details == DetailsBetween::linger);
    report.constraints = problem.held.back().vertices.size();
    for (std::size_t f = 0; f < options_.features.size(); ++f) add_line(problem, line(f, figures));
    for (const EnhancedTransition& transition : options_.transitions) add_transition(transition, problem);
    return fit_multiresolution(problem, {.gamma = options_.gamma, .smoothing_passes = options_.smoothing_passes},
                               progress);
  }

 private:
  double time_mm(double share) const { return times_mm_[0] + share * (times_mm_[times_mm_.size() - 1] - times_mm_[0]); }

  /// Sources and topological key shapes in the order of t; the features' layers follow.
  void make_layers() {
    for (std::size_t i = 0; i < figures_.size(); ++i)
      layers_.push_back({.t_mm = times_mm_[static_cast<Eigen::Index>(i)], .contours = figures_[i].contours});
    for (const TopologicalKeyShape& key : options_.key_shapes) {
      const std::string name = key.name.empty() ? "key shape" : key.name;
      const auto* figure = std::get_if<ContourSlice>(&key.shape);
      if (figure == nullptr) throw InputError(name, "it is a body", "figures take figures as topological key shapes");
      if (!(key.t > 0 && key.t < 1))
        throw InputError(name, fmt::format("its time {:g} is not between those of the shapes", key.t),
                         "give a time between 0 and 1");
      const double t_mm = time_mm(key.t);
      for (const FigureLayer& layer : layers_)
        if (std::abs(layer.t_mm - t_mm) < 1e-6 * (times_mm_[times_mm_.size() - 1] - times_mm_[0]))
          throw InputError(name, fmt::format("another shape is at its time {:g}", key.t), "give a time of its own");
      NamedFigure named{.name = name, .contours = moved_to(common_pose(shapes_), figure->contours, figure->pose)};
      std::erase_if(named.contours, [](const Contour& c) { return c.points_mm.size() < 3 || signed_area_mm2(c) == 0; });
      if (named.contours.empty()) throw InputError(name, "nothing in it is inside", "draw its curves");
      orient_by_nesting(named.contours);
      require_no_crossing(named);
      layers_.push_back({.t_mm = t_mm, .contours = std::move(named.contours), .topological = true});
    }
    std::vector<std::size_t> order(layers_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return layers_[a].t_mm < layers_[b].t_mm; });
    std::vector<FigureLayer> sorted;
    std::vector<int> place_of(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      place_of[order[i]] = static_cast<int>(i);
      sorted.push_back(layers_[order[i]]);
    }
    for (auto& feature : points_)
      for (SourcePoint& point : feature) point.layer = place_of[static_cast<std::size_t>(point.layer)];
    layers_ = std::move(sorted);
  }

  int base_vertex(const FigureInterpolator& figures, const SourcePoint& point) const {
    for (const SourceLoop& loop : figures.sources) {
      if (loop.layer != point.layer || loop.contour != point.contour) continue;
      for (std::size_t b = 0; b < loop.vertices.size(); ++b)
        if (loop.levels.base[b] == point.point) return loop.vertices[b];
    }
    return -1;
  }

  FeatureLine line(std::size_t f, const FigureInterpolator& figures) const {
    const CorrespondingPoints& feature = options_.features[f];
    FeatureLine result{.ends = {base_vertex(figures, points_[f][0]), base_vertex(figures, points_[f][1])},
                       .by_way_of = Eigen::MatrixXd(3, static_cast<Eigen::Index>(feature.by_way_of.size())),
                       .sharp = feature.sharp};
    for (std::size_t i = 0; i < feature.by_way_of.size(); ++i) {
      const TimedPlace& place = feature.by_way_of[i];
      if (place.place_mm.size() != 2 || !place.place_mm.allFinite())
        throw InputError("feature", "a place on its way has not two coordinates", "give x and y in slice mm");
      result.by_way_of.col(static_cast<Eigen::Index>(i)) << place.place_mm, time_mm(place.t);
    }
    return result;
  }

  void add_transition(const EnhancedTransition& transition, FitProblem& problem) const {
    if (transition.level < 1 || transition.level > options_.levels)
      throw InputError("transition", fmt::format("level {} of {}", transition.level, options_.levels),
                       "give a level from 1 to that of --levels");
    if (!(transition.at.t > 0 && transition.at.t < 1) || transition.at.place_mm.size() != 2 ||
        transition.to_mm.size() != 2)
      throw InputError("transition", "it is not at a time between 0 and 1 with places of two coordinates",
                       "give t, place_mm and to_mm");
    Eigen::Vector3d at;
    at << transition.at.place_mm, time_mm(transition.at.t);
    add_pull(problem, transition.level, at, transition.to_mm);
  }

  const std::vector<KeyShape>& shapes_;
  const SubdivisionMorphOptions& options_;
  Eigen::RowVectorXd times_mm_;
  std::vector<NamedFigure> figures_;
  std::vector<std::array<SourcePoint, 2>> points_;
  std::vector<FigureLayer> layers_;
};

}  // namespace

std::unique_ptr<MorphMethod> subdivided_figures(const std::vector<KeyShape>& shapes,
                                                const SubdivisionMorphOptions& options, const KeyPlaces& places,
                                                double spacing_mm, MorphReport& report, const Progress& progress) {
  const Eigen::RowVectorXd key_times_mm = spacing_mm * places.coordinates.row(0);
  FigureMaker maker(shapes, options, key_times_mm);
  const Stopwatch watch;
  FittedMesh fitted = maker.fitted(report, progress);
  report.solve_seconds = watch.seconds();
  report.levels = fitted.levels;
  return std::make_unique<SubdividedFigures>(std::move(fitted.mesh), shapes, key_times_mm, options.warp);
}

}  // namespace isostack
