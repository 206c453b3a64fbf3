#include "recon/subdivision/body_interpolator.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "recon/geometry/errors.h"
#include "recon/subdivision/base_mesh.h"
#include "recon/subdivision/base_tetrahedra.h"
#include "recon/subdivision/domain_features.h"
#include "recon/subdivision/surface_map.h"

namespace isostack {

namespace {

std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

std::string name_of(const TriangleMesh& mesh) { return mesh.name.empty() ? "surface" : mesh.name; }

void require_one_genus(const std::vector<BodyLayer>& layers) {
  const int first = genus_of(layers.front().body);
  for (const BodyLayer& layer : layers) {
    const int genus = genus_of(layer.body);
    if (genus != first)
      throw InputError(
          name_of(layer.body),
          fmt::format("the surface has genus {}, but {} has genus {}", genus, name_of(layers.front().body), first),
          "use one of the methods variational, level-set or blend, which change the genus");
  }
}

std::vector<DomainMesh> drawn_surfaces(const std::vector<BodyLayer>& layers, const Progress& progress) {
  std::vector<DomainMesh> drawn;
  for (const BodyLayer& layer : layers) drawn.push_back(spread_over_domain(layer.body, {}, progress));
  return drawn;
}

/// Level 0 of each layer, and which of its vertices are features.
struct LayerBases {
  std::vector<DomainMesh> drawn;  ///< the layers' bodies, features in their places
  std::vector<DomainMesh> bases;
  std::vector<std::map<int, int>> base_vertex_of;  ///< of each layer: corners of the body that are base vertices
};

/// Features at their counterparts' places, new ones where they are (on a torus at the nearest base vertices that are
/// free), so that a pair is one place of the domain.
class FeaturePlaces {
 public:
  FeaturePlaces(const AlignedDomains& domains, const BodyInterpolatorOptions& options)
      : domains_(domains), options_(options) {}

  /// Layers are asked for one after the other.
  std::vector<PulledVertex> next(std::size_t layer) {
    std::vector<PulledVertex> made;
    const auto add = [&](int vertex, const Eigen::Vector3d& target) {
      for (const PulledVertex& other : made)
        if (other.vertex == vertex) return;
      made.push_back({vertex, target});
    };
    if (layer > 0 && layer <= options_.features.size())
      for (const VertexPair& pair : options_.features[layer - 1]) add(pair.to, place_of(pair.from));
    if (layer < options_.features.size())
      for (const VertexPair& pair : options_.features[layer]) {
        const Eigen::Vector3d own = domains_.drawn[layer].positions[index(pair.from)];
        add(pair.from, domains_.drawn[layer].domain.genus == 0 ? own : free_base_vertex(own, made));
      }
    last_ = made;
    return made;
  }

 private:
  Eigen::Vector3d place_of(int vertex) const {
    return std::find_if(last_.begin(), last_.end(), [&](const auto& one) { return one.vertex == vertex; })->target;
  }

  Eigen::Vector3d free_base_vertex(const Eigen::Vector3d& p, const std::vector<PulledVertex>& taken) const {
    const DomainMesh base = torus_base(domains_.around);
    Eigen::Vector3d best = p;
    double least = std::numeric_limits<double>::max();
    for (const Eigen::Vector3d& q : base.positions) {
      const double distance = base.domain.distance(p, q);
      const bool is_free = std::none_of(taken.begin(), taken.end(), [&](const auto& one) { return one.target == q; });
      if (!is_free || distance >= least) continue;
      least = distance;
      best = q;
    }
    return best;
  }

  const AlignedDomains& domains_;
  const BodyInterpolatorOptions& options_;
  std::vector<PulledVertex> last_;
};

LayerBases layer_bases(const std::vector<BodyLayer>& layers, AlignedDomains domains,
                       const BodyInterpolatorOptions& options) {
  LayerBases made;
  FeaturePlaces places(domains, options);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::vector<PulledVertex> features = places.next(i);
    made.drawn.push_back(pulled(layers[i].body, domains.drawn[i], features));
    std::vector<Eigen::Vector3d> points;
    std::map<int, int>& numbers = made.base_vertex_of.emplace_back();
    for (const PulledVertex& one : features) {
      numbers[one.vertex] = static_cast<int>(points.size());
      points.push_back(one.target);
    }
    if (domains.drawn[i].domain.genus == 0) {
      if (!options.kept.empty())
        for (const int v : options.kept[i])
          if (numbers.try_emplace(v, static_cast<int>(points.size())).second)
            points.push_back(made.drawn[i].positions[index(v)]);
      made.bases.push_back(sphere_base(points));
      continue;
    }
    made.bases.push_back(torus_base(domains.around));
    const auto& vertices = made.bases.back().positions;
    for (auto& [vertex, number] : numbers)
      number = static_cast<int>(std::find(vertices.begin(), vertices.end(), points[index(number)]) - vertices.begin());
  }
  return made;
}

/// The numbers in the interpolator of a source's vertices at level k + 1, from those at level k.
std::vector<int> refined_numbers(const std::vector<int>& numbers, const SimplexSubdivision& own,
                                 const SimplexSubdivision& interpolator, Eigen::Index coarse_count) {
  std::vector<int> finer = numbers;
  for (const auto& [a, b] : own.edges) {
    const auto [low, high] = std::minmax(numbers[index(a)], numbers[index(b)]);
    const std::array<int, 2> edge{low, high};
    const auto at = std::lower_bound(interpolator.edges.begin(), interpolator.edges.end(), edge);
    finer.push_back(static_cast<int>(coarse_count + (at - interpolator.edges.begin())));
  }
  return finer;
}

double t_of(const BodyInterpolator& interpolator, const SourceSurface& source) {
  return interpolator.base.vertices(3, source.vertices.front());
}

/// The straight blends of neighbouring sources at the vertices' places on the domain.
Eigen::MatrixXd blended_places(const BodyInterpolator& interpolator, const SubdivisionLevels& levels) {
  const SurfaceDomain& domain = interpolator.sources.front().drawn.domain;
  std::vector<Eigen::Vector3d> points = interpolator.on_domain;
  std::vector<double> t_mm(interpolator.base.vertices.row(3).begin(), interpolator.base.vertices.row(3).end());
  for (const SimplexSubdivision& step : levels.steps)
    for (const auto& [a, b] : step.edges) {
      points.push_back(domain.halfway(points[index(a)], points[index(b)]));
      t_mm.push_back((t_mm[index(a)] + t_mm[index(b)]) / 2);
    }
  Eigen::MatrixXd places = Eigen::MatrixXd::Zero(3, static_cast<Eigen::Index>(points.size()));
  for (const SourceSurface& source : interpolator.sources) {
    const double own = t_of(interpolator, source);
    std::vector<std::pair<std::size_t, double>> shares;  // vertices between this source and its neighbours
    std::vector<Eigen::Vector3d> near;
    for (std::size_t v = 0; v < points.size(); ++v) {
      double share = t_mm[v] == own ? 1 : 0;
      for (const SourceSurface& other : interpolator.sources) {
        const double there = t_of(interpolator, other);
        const bool is_neighbour = std::abs(&other - &source) == 1;
        if (is_neighbour && (t_mm[v] - own) * (t_mm[v] - there) < 0) share = (t_mm[v] - there) / (own - there);
      }
      if (share == 0) continue;
      shares.emplace_back(v, share);
      near.push_back(points[v]);
    }
    const Eigen::Matrix3Xd on_source = places_on(source.body, source.drawn, near);
    for (std::size_t i = 0; i < shares.size(); ++i)
      places.col(static_cast<Eigen::Index>(shares[i].first)) +=
          shares[i].second * on_source.col(static_cast<Eigen::Index>(i));
  }
  return places;
}

}  // namespace

BodyInterpolator body_interpolator(const std::vector<BodyLayer>& layers, const BodyInterpolatorOptions& options,
                                   const Progress& progress) {
  require_one_genus(layers);
  std::vector<const TriangleMesh*> bodies;
  for (const BodyLayer& layer : layers) bodies.push_back(&layer.body);
  const LayerBases drawn =
      layer_bases(layers, aligned(bodies, drawn_surfaces(layers, progress), options.features), options);

  BodyInterpolator made;
  std::vector<Eigen::Vector4d> vertices;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    SourceSurface& source = made.sources.emplace_back();
    source.body = layers[i].body;
    source.drawn = drawn.drawn[i];
    source.surface = subdivided(layers[i].body, source.drawn, drawn.bases[i], options.levels);
    source.fit = fit_of(source.surface, layers[i].body);
    for (Eigen::Index v = 0; v < source.surface.levels.base_vertex_count; ++v) {
      source.vertices.push_back(static_cast<int>(vertices.size()));
      made.on_domain.push_back(drawn.bases[i].positions[index(v)]);
      vertices.emplace_back(source.surface.places_mm(0, v), source.surface.places_mm(1, v),
                            source.surface.places_mm(2, v), layers[i].t_mm);
    }
  }
  for (std::size_t i = 0; i < options.features.size(); ++i)
    for (const VertexPair& pair : options.features[i])
      made.features.push_back({made.sources[i].vertices[index(drawn.base_vertex_of[i].at(pair.from))],
                               made.sources[i + 1].vertices[index(drawn.base_vertex_of[i + 1].at(pair.to))]});
  std::vector<Eigen::Vector4i> simplices;
  for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
    const Eigen::MatrixXi between = base_tetrahedra(drawn.bases[i], drawn.bases[i + 1]);
    for (Eigen::Index t = 0; t < between.cols(); ++t)
      simplices.emplace_back(between.col(t).array() + made.sources[i].vertices.front());
  }
  made.base.vertices.resize(4, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t v = 0; v < vertices.size(); ++v) made.base.vertices.col(static_cast<Eigen::Index>(v)) = vertices[v];
  made.base.simplices.resize(4, static_cast<Eigen::Index>(simplices.size()));
  for (std::size_t t = 0; t < simplices.size(); ++t)
    made.base.simplices.col(static_cast<Eigen::Index>(t)) = simplices[t];
  return made;
}

std::vector<int> source_numbers(const SourceSurface& source, const SubdivisionLevels& levels) {
  std::vector<int> numbers = source.vertices;
  for (int k = 0; k < levels.finest(); ++k)
    numbers =
        refined_numbers(numbers, source.surface.levels.steps[index(k)], levels.steps[index(k)], levels.vertex_count(k));
  return numbers;
}

FitProblem fit_problem(const BodyInterpolator& interpolator, bool details) {
  const int finest = interpolator.sources.front().surface.levels.finest();
  FitProblem problem;
  problem.levels = subdivision_levels(interpolator.base.simplices, interpolator.base.vertex_count(), finest);
  problem.base = interpolator.base.vertices;
  problem.held.resize(index(finest) + 1);
  for (const SourceSurface& source : interpolator.sources) {
    const std::vector<int> numbers = source_numbers(source, problem.levels);
    for (int k = 0; k <= finest; ++k) {
      PlacedVertices& held = problem.held[index(k)];
      const auto before = static_cast<Eigen::Index>(held.vertices.size());
      const Eigen::Index count = source.surface.levels.vertex_count(k);
      held.vertices.insert(held.vertices.end(), numbers.begin(), numbers.begin() + count);
      held.places_mm.conservativeResize(3, before + count);
      held.places_mm.rightCols(count) = source.surface.places_mm.leftCols(count);
    }
  }
  if (!details) return problem;
  const Eigen::MatrixXd places = blended_places(interpolator, problem.levels);
  for (int k = 0; k <= finest; ++k) problem.reference.push_back(places.leftCols(problem.levels.vertex_count(k)));
  return problem;
}

}  // namespace isostack
