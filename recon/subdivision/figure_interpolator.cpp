#include "recon/subdivision/figure_interpolator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recon/subdivision/figure_strips.h"
#include "recon/subdivision/pinched_loops.h"

namespace isostack {

namespace {

constexpr double touching = 1e-3;  // of the figure's size: nearer than this curves of a key shape touch

/// The rings a layer shows to the layer before it and to that after it.
struct LayerRings {
  std::vector<VertexRing> before, after;
};

LoopCount count_of(const std::vector<Contour>& contours) {
  LoopCount result;
  for (const Contour& contour : contours) ++(signed_area_mm2(contour) > 0 ? result.outer : result.holes);
  return result;
}

double size_mm(const std::vector<Contour>& contours) {
  Eigen::AlignedBox2d box;
  for (const Contour& contour : contours)
    for (const Eigen::Vector2d& point : contour.points_mm) box.extend(point);
  return box.diagonal().norm();
}

std::vector<int> kept_points(const FigureInterpolatorOptions& options, int layer, int contour) {
  std::vector<int> kept;
  for (const auto& feature : options.features)
    for (const SourcePoint& point : feature)
      if (point.layer == layer && point.contour == contour) kept.push_back(point.point);
  return kept;
}

/// The contours with points on edges where points of others touch them.
std::vector<Contour> with_touching_points(std::vector<Contour> contours, double tolerance_mm) {
  for (std::size_t i = 0; i < contours.size(); ++i)
    for (std::size_t j = 0; j < contours.size(); ++j) {
      if (i == j) continue;
      auto& points = contours[j].points_mm;
      for (const Eigen::Vector2d& point : contours[i].points_mm)
        for (std::size_t e = 0; e < points.size(); ++e) {
          const Eigen::Vector2d side = points[(e + 1) % points.size()] - points[e];
          const double share = (point - points[e]).dot(side) / side.squaredNorm();
          const bool inside = share * side.norm() > tolerance_mm && (1 - share) * side.norm() > tolerance_mm;
          if (!inside || (point - points[e] - share * side).norm() > tolerance_mm) continue;
          points.insert(points.begin() + static_cast<std::ptrdiff_t>(e) + 1, point);
          break;
        }
    }
  return contours;
}

class Interpolator {
 public:
  Interpolator(const std::vector<FigureLayer>& layers, const FigureInterpolatorOptions& options)
      : layers_(layers), options_(options) {}

  FigureInterpolator make() {
    std::vector<LayerRings> rings;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      if (layers_[i].topological)
        rings.push_back(key_rings(i));
      else
        rings.push_back(source_rings(static_cast<int>(i)));
    }
    for (std::size_t i = 0; i + 1 < layers_.size(); ++i) join(static_cast<int>(i), rings);
    result_.base = strips_.mesh();
    return std::move(result_);
  }

 private:
  LayerRings source_rings(int layer) {
    const FigureLayer& source = layers_[static_cast<std::size_t>(layer)];
    LayerRings rings;
    for (std::size_t c = 0; c < source.contours.size(); ++c) {
      ContourLevelsOptions options = options_.contours;
      options.kept = kept_points(options_, layer, static_cast<int>(c));
      SourceLoop loop{.layer = layer,
                      .contour = static_cast<int>(c),
                      .levels = contour_levels(source.contours[c], options),
                      .vertices = {}};
      for (Eigen::Index e = 0; e < loop.levels.base_count(); ++e)
        loop.vertices.push_back(strips_.add_vertex(loop.levels.at(e, 0), source.t_mm));
      rings.before.push_back({.vertices = loop.vertices, .is_hole = signed_area_mm2(source.contours[c]) < 0});
      result_.sources.push_back(std::move(loop));
    }
    rings.after = rings.before;
    return rings;
  }

  /// The key shape's curves as polygons of few corners, the places where they touch among these.
  PinchedLoops key_loops(const FigureLayer& key) const {
    const double tolerance_mm = touching * size_mm(key.contours);
    const std::vector<Contour> contours = with_touching_points(key.contours, tolerance_mm);
    std::vector<std::vector<Eigen::Vector2d>> curves, polygons;
    for (const Contour& contour : contours) curves.push_back(contour.points_mm);
    const PinchedLoops all = pinched_loops(curves, tolerance_mm);
    int first = 0;
    for (const Contour& contour : contours) {
      ContourLevelsOptions options = options_.contours;
      options.sharp_angle_rad.reset();
      for (const auto& [a, b] : all.pinches)
        for (const int pass : {a, b})
          if (pass >= first && pass < first + static_cast<int>(contour.points_mm.size()))
            options.kept.push_back(pass - first);
      first += static_cast<int>(contour.points_mm.size());
      const ContourLevels levels = contour_levels(contour, options);
      polygons.emplace_back();
      for (Eigen::Index e = 0; e < levels.base_count(); ++e) polygons.back().push_back(levels.at(e, 0));
    }
    return pinched_loops(polygons, tolerance_mm);
  }

  LayerRings key_rings(std::size_t layer) {
    const PinchedLoops loops = key_loops(layers_[layer]);
    const std::vector<bool> before = switched_for(loops, count_of(layers_[layer - 1].contours));
    const std::vector<bool> after = switched_for(loops, count_of(layers_[layer + 1].contours));
    std::vector<int> vertex_of(loops.next.size(), -1);
    for (std::size_t p = 0; p < loops.pinches.size(); ++p) {
      const auto [a, b] = loops.pinches[p];
      if (before[p] == after[p]) continue;  // loops only touch: each keeps a vertex of its own
      const int shared = strips_.add_vertex(loops.places_mm[static_cast<std::size_t>(a)], layers_[layer].t_mm);
      vertex_of[static_cast<std::size_t>(a)] = vertex_of[static_cast<std::size_t>(b)] = shared;
    }
    for (std::size_t p = 0; p < loops.next.size(); ++p)
      if (vertex_of[p] < 0) vertex_of[p] = strips_.add_vertex(loops.places_mm[p], layers_[layer].t_mm);
    result_.key_vertices.insert(result_.key_vertices.end(), vertex_of.begin(), vertex_of.end());
    const auto rings_of = [&](const std::vector<bool>& switched) {
      std::vector<VertexRing> rings;
      for (const std::vector<int>& loop : loops.loops(switched)) {
        rings.push_back({.vertices = {}, .is_hole = loops.signed_area_mm2(loop) < 0});
        for (const int pass : loop) rings.back().vertices.push_back(vertex_of[static_cast<std::size_t>(pass)]);
      }
      return rings;
    };
    return {.before = rings_of(before), .after = rings_of(after)};
  }

  int vertex_of(const SourcePoint& point) const {
    for (const SourceLoop& loop : result_.sources) {
      if (loop.layer != point.layer || loop.contour != point.contour) continue;
      const auto at = std::find(loop.levels.base.begin(), loop.levels.base.end(), static_cast<double>(point.point));
      return loop.vertices[static_cast<std::size_t>(at - loop.levels.base.begin())];
    }
    return -1;
  }

  void join(int layer, const std::vector<LayerRings>& rings) {
    std::vector<JoinedVertices> joined;
    for (auto [a, b] : options_.features) {
      if (a.layer > b.layer) std::swap(a, b);
      if (a.layer != layer || b.layer != layer + 1) continue;
      joined.push_back({.lower = vertex_of(a), .upper = vertex_of(b)});
    }
    const auto i = static_cast<std::size_t>(layer);
    strips_.join(rings[i].after, rings[i + 1].before, joined);
  }

  const std::vector<FigureLayer>& layers_;
  const FigureInterpolatorOptions& options_;
  FigureStrips strips_;
  FigureInterpolator result_;
};

}  // namespace

FigureInterpolator figure_interpolator(const std::vector<FigureLayer>& layers,
                                       const FigureInterpolatorOptions& options) {
  return Interpolator(layers, options).make();
}

}  // namespace isostack
