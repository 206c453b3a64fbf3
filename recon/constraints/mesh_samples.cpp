#include "recon/constraints/mesh_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>

#include "recon/geometry/disjoint_sets.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"

namespace isostack {

namespace {

const Eigen::Vector3d& corner(const TriangleMesh& mesh, const Eigen::Vector3i& triangle, int i) {
  return mesh.vertices_mm[static_cast<std::size_t>(triangle[i % 3])];
}

Eigen::Vector3d area_normal(const TriangleMesh& mesh, const Eigen::Vector3i& t) {
  return (corner(mesh, t, 1) - corner(mesh, t, 0)).cross(corner(mesh, t, 2) - corner(mesh, t, 0));
}

/// Zero at vertices no triangle uses.
std::vector<Eigen::Vector3d> angle_weighted_normals(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> sums(mesh.vertices_mm.size(), Eigen::Vector3d::Zero());
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Eigen::Vector3d normal = area_normal(mesh, t).stableNormalized();
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d a = corner(mesh, t, i + 1) - corner(mesh, t, i),
                            b = corner(mesh, t, i + 2) - corner(mesh, t, i);
      sums[static_cast<std::size_t>(t[i])] += std::atan2(a.cross(b).norm(), a.dot(b)) * normal;
    }
  }
  for (Eigen::Vector3d& sum : sums) sum.stableNormalize();
  return sums;
}

/// Points by the cubes of a grid, found within the cubes' edge.
class DiscGrid {
 public:
  explicit DiscGrid(double radius) : radius_(radius) {}

  /// Keeps the sample unless one that looks the same way is nearer than the radius: the two sides of a thin sheet are
  /// different places.
  bool insert(const MeshSample& sample) {
    const Eigen::Vector3i cube = (sample.point_mm / radius_).array().floor().cast<int>();
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
          const auto found = cubes_.find(key(cube + Eigen::Vector3i(i, j, k)));
          if (found == cubes_.end()) continue;
          for (const MeshSample& other : found->second)
            if ((other.point_mm - sample.point_mm).squaredNorm() < radius_ * radius_ &&
                other.outward.dot(sample.outward) > 0)
              return false;
        }
    cubes_[key(cube)].push_back(sample);
    return true;
  }

 private:
  static std::uint64_t key(const Eigen::Vector3i& cube) {
    constexpr std::uint64_t mask = (1U << 21) - 1;
    std::uint64_t result = 0;
    for (const int place : cube) result = result << 21 | (static_cast<std::uint64_t>(place) & mask);
    return result;
  }

  double radius_;
  std::unordered_map<std::uint64_t, std::vector<MeshSample>> cubes_;
};

std::vector<MeshSample> thinned(const std::vector<MeshSample>& pool, double radius) {
  DiscGrid grid(radius);
  std::vector<MeshSample> kept;
  for (const MeshSample& sample : pool)
    if (grid.insert(sample)) kept.push_back(sample);
  return kept;
}

/// Discs over the mesh, which need not be closed.
std::vector<MeshSample> spread_over(const TriangleMesh& mesh, std::size_t most, const MeshSamplingOptions& options) {
  constexpr std::size_t pool_per_sample = 12;
  if (mesh.triangles.empty() || most == 0) return {};
  std::vector<MeshSample> pool;
  for (const SurfacePoint& p : sample_triangles(mesh, pool_per_sample * most, options.seed))
    pool.push_back({p.point_mm, area_normal(mesh, mesh.triangles[p.triangle]).stableNormalized()});
  // No more discs of this distance than wanted lie in the area, by their densest packing.
  double enough_mm = std::sqrt(2 / std::sqrt(3.0) * measure(mesh).area_mm2 / static_cast<double>(most));
  if (options.min_spacing_mm >= enough_mm) return thinned(pool, options.min_spacing_mm);
  double few_mm = std::max(options.min_spacing_mm, enough_mm / 4);
  std::vector<MeshSample> best = thinned(pool, few_mm);
  if (best.size() <= most) return best;
  best = thinned(pool, enough_mm);
  for (int step = 0; step < 10; ++step) {
    const double middle_mm = (few_mm + enough_mm) / 2;
    std::vector<MeshSample> tried = thinned(pool, middle_mm);
    const bool fits = tried.size() <= most;
    (fits ? enough_mm : few_mm) = middle_mm;
    if (fits) best = std::move(tried);
  }
  return best;
}

/// The mesh's triangles by the connected part they belong to.
std::vector<std::vector<Eigen::Vector3i>> parts_of(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices_mm.size());
  for (const Eigen::Vector3i& t : mesh.triangles)
    for (int i = 0; i < 2; ++i) sets.join(static_cast<std::size_t>(t[i]), static_cast<std::size_t>(t[i + 1]));
  std::vector<std::vector<Eigen::Vector3i>> parts;
  std::unordered_map<std::size_t, std::size_t> number_of;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const std::size_t number = number_of.emplace(sets.root(static_cast<std::size_t>(t[0])), parts.size()).first->second;
    if (number == parts.size()) parts.emplace_back();
    parts[number].push_back(t);
  }
  return parts;
}

TriangleMesh with_triangles(const TriangleMesh& mesh, std::vector<Eigen::Vector3i> triangles) {
  TriangleMesh part;
  part.vertices_mm = mesh.vertices_mm;
  part.triangles = std::move(triangles);
  return part;
}

std::string name_of(const TriangleMesh& mesh) { return mesh.name.empty() ? "mesh" : mesh.name; }

}  // namespace

void require_closed(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw InputError(name_of(mesh), "the mesh has no triangles", "give a surface");
  for (const Eigen::Vector3d& vertex : mesh.vertices_mm)
    if (!vertex.allFinite()) throw InputError(name_of(mesh), "a vertex is not finite", "repair the mesh");
  const MeshMeasures measures = measure(mesh);
  if (measures.boundary_edges > 0)
    throw InputError(name_of(mesh), std::to_string(measures.boundary_edges) + " edges have a triangle on one side only",
                     "close the mesh, or have it mended");
  if (!measures.watertight())
    throw InputError(name_of(mesh), "triangles cross in an edge or disagree about the outside",
                     "repair the mesh, or have it mended");
  if (!(measures.volume_mm3 > 0))
    throw InputError(name_of(mesh), "the mesh encloses no volume, or its triangles face inwards",
                     "turn it inside out, or have it mended");
}

std::vector<MeshSample> vertex_samples(const TriangleMesh& mesh) {
  require_closed(mesh);
  const std::vector<Eigen::Vector3d> computed = angle_weighted_normals(mesh);
  const bool has_normals = mesh.normals.size() == mesh.vertices_mm.size();
  std::vector<MeshSample> samples;
  for (std::size_t v = 0; v < computed.size(); ++v)
    if (!computed[v].isZero()) samples.push_back({mesh.vertices_mm[v], has_normals ? mesh.normals[v] : computed[v]});
  return samples;
}

std::vector<MeshSample> spread_samples(const TriangleMesh& mesh, const MeshSamplingOptions& options) {
  require_closed(mesh);
  const auto most = static_cast<double>(options.max_samples);
  const double area_mm2 = measure(mesh).area_mm2;
  TriangleMesh large = with_triangles(mesh, {});
  std::vector<std::vector<Eigen::Vector3i>> small;
  for (std::vector<Eigen::Vector3i>& triangles : parts_of(mesh)) {
    double part_mm2 = 0;
    for (const Eigen::Vector3i& t : triangles) part_mm2 += area_normal(mesh, t).norm() / 2;
    if (most * part_mm2 < static_cast<double>(options.least_per_part) * area_mm2)
      small.push_back(std::move(triangles));
    else
      large.triangles.insert(large.triangles.end(), triangles.begin(), triangles.end());
  }
  // Very many small parts share half of the samples.
  const std::size_t each = small.empty() ? 0 : std::min(options.least_per_part, options.max_samples / 2 / small.size());
  std::vector<MeshSample> samples = spread_over(large, options.max_samples - each * small.size(), options);
  for (std::vector<Eigen::Vector3i>& triangles : small) {
    const std::vector<MeshSample> few = spread_over(with_triangles(mesh, std::move(triangles)), each, options);
    samples.insert(samples.end(), few.begin(), few.end());
  }
  return samples;
}

}  // namespace isostack
