#include "recon/surface/remesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/point_triangle.h"
#include "recon/surface/crease.h"
#include "recon/surface/editable_mesh.h"
#include "recon/surface/projection.h"

namespace isostack {

namespace {

// Triangles may not turn farther than this in one step: folds cannot come about.
constexpr double collapse_cosine = 0.5, relax_cosine = 0.3, flip_cosine = 0.75;
// Of the edge length: how far collapses may move a crease, all together.
constexpr double crease_limit = 0.1;

/// A longer edge's halves are nearer to the target than it is, two shorter edges' union likewise, mm.
double longest_edge(const RemeshOptions& options) { return options.edge_length_mm * 4 / 3; }
double shortest_edge(const RemeshOptions& options) { return options.edge_length_mm * 4 / 5; }

/// How far the crease near each vertex may have been moved so far, mm.
using CreaseDrift = std::vector<double>;

double& at(CreaseDrift& drift, int v) { return drift[static_cast<std::size_t>(v)]; }

void split_long_edges(EditableMesh& mesh, double longest_mm, CreaseDrift& drift) {
  // Halves are appended, so this comes to them; a neighbour passed before has no longer edges than the one split.
  for (int t = 0; t < mesh.triangle_slots(); ++t) {
    while (mesh.has_triangle(t)) {
      const Eigen::Vector3i corners = mesh.triangle(t);
      int longest = -1;
      double length = longest_mm;
      for (int side = 0; side < 3; ++side) {
        const int a = corners[side], b = corners[(side + 1) % 3];
        if (mesh.length(a, b) > length && !mesh.sides(a, b).is_border()) longest = side, length = mesh.length(a, b);
      }
      if (longest < 0) break;
      const int a = corners[longest], b = corners[(longest + 1) % 3];
      mesh.split(a, b);
      drift.push_back(std::max(at(drift, a), at(drift, b)));
    }
  }
}

/// How far the triangles left behind miss a vertex on a crease that goes; 0 along the crease.
double crease_miss_mm(const EditableMesh& mesh, int keep, int gone, const Crease& crease) {
  const Eigen::Vector3d edge = mesh.position(keep) - mesh.position(gone);
  if (crease.freedom == Freedom::line && std::abs(crease.along.dot(edge)) > 0.9 * edge.norm()) return 0;
  double miss_mm = edge.norm();
  for (const int t : mesh.triangles_at(gone)) {
    Triangle after;
    for (std::size_t i = 0; i < 3; ++i) {
      const int corner = mesh.triangle(t)[static_cast<Eigen::Index>(i)];
      after[i] = mesh.position(corner == gone ? keep : corner);
    }
    const Eigen::Vector3d& was = mesh.position(gone);
    miss_mm = std::min(miss_mm, (closest_point_on_triangle(after, was) - was).norm());
  }
  return miss_mm;
}

/// No other edge gets longer than the limit, no triangle turns over, no crease is moved far.
void collapse_short_edge(EditableMesh& mesh, int a, int b, const RemeshOptions& options, CreaseDrift& drift) {
  const Crease at_a = crease_at(mesh, a), at_b = crease_at(mesh, b);
  const bool keeps_b = mesh.is_fixed(b) || (at_b.freedom < at_a.freedom && !mesh.is_fixed(a));
  const int keep = keeps_b ? b : a, gone = keeps_b ? a : b;
  const Crease& leaving = keeps_b ? at_a : at_b;
  if (!mesh.may_collapse(keep, gone)) return;
  const bool both_free = !mesh.is_fixed(keep) && at_a.freedom == Freedom::plane && at_b.freedom == Freedom::plane;
  const double missed_mm = leaving.freedom == Freedom::plane ? 0 : crease_miss_mm(mesh, keep, gone, leaving);
  const double drift_mm = std::max(at(drift, a), at(drift, b)) + missed_mm;
  if (missed_mm > 0 && drift_mm > crease_limit * options.edge_length_mm) return;
  const Eigen::Vector3d there =
      both_free ? Eigen::Vector3d((mesh.position(a) + mesh.position(b)) / 2) : mesh.position(keep);
  for (const int v : {keep, gone})
    for (const int other : mesh.neighbours(v))
      if ((mesh.position(other) - there).norm() > longest_edge(options) && other != keep && other != gone) return;
  if (!mesh.keeps_directions(gone, there, collapse_cosine, keep)) return;
  if (!mesh.is_fixed(keep) && !mesh.keeps_directions(keep, there, collapse_cosine, gone)) return;
  mesh.collapse(keep, gone, there);
  at(drift, keep) = drift_mm;
}

void collapse_short_edges(EditableMesh& mesh, const RemeshOptions& options, CreaseDrift& drift) {
  for (int t = 0; t < mesh.triangle_slots(); ++t)
    for (int side = 0; side < 3 && mesh.has_triangle(t); ++side) {
      const int a = mesh.triangle(t)[side], b = mesh.triangle(t)[(side + 1) % 3];
      if (mesh.length(a, b) < shortest_edge(options)) collapse_short_edge(mesh, a, b, options, drift);
    }
}

/// How far v is from having the neighbours of an even mesh: six, four on a border.
int valence_error(const EditableMesh& mesh, int v, int change) {
  const int triangles = static_cast<int>(mesh.triangles_at(v).size()) + change;
  const int error = triangles - (mesh.is_fixed(v) ? 3 : 6);
  return error * error;
}

bool flip_is_flat(const EditableMesh& mesh, int a, int b, const EditableMesh::Sides& edge) {
  const Eigen::Vector3d left = mesh.area_normal(edge.triangles[0]), right = mesh.area_normal(edge.triangles[1]);
  const Eigen::Vector3d &pa = mesh.position(a), &pb = mesh.position(b), &pc = mesh.position(edge.opposite[0]),
                        &pd = mesh.position(edge.opposite[1]);
  const Eigen::Vector3d at_a = (pa - pc).cross(pd - pc), at_b = (pb - pd).cross(pc - pd);
  const Eigen::Vector3d out = left + right;
  const auto agrees = [&](const Eigen::Vector3d& normal) {
    return normal.dot(out) > flip_cosine * normal.norm() * out.norm();
  };
  return left.dot(right) > flip_cosine * left.norm() * right.norm() && agrees(at_a) && agrees(at_b);
}

void flip_towards_six(EditableMesh& mesh) {
  for (int t = 0; t < mesh.triangle_slots(); ++t)
    for (int side = 0; side < 3 && mesh.has_triangle(t); ++side) {
      const int a = mesh.triangle(t)[side], b = mesh.triangle(t)[(side + 1) % 3];
      const EditableMesh::Sides edge = mesh.sides(a, b);
      if (edge.is_border()) continue;
      const auto [c, d] = edge.opposite;
      const int before =
          valence_error(mesh, a, 0) + valence_error(mesh, b, 0) + valence_error(mesh, c, 0) + valence_error(mesh, d, 0);
      const int after = valence_error(mesh, a, -1) + valence_error(mesh, b, -1) + valence_error(mesh, c, 1) +
                        valence_error(mesh, d, 1);
      if (after < before && mesh.may_flip(a, b) && flip_is_flat(mesh, a, b, edge)) mesh.flip(a, b);
    }
}

/// Towards the centroid of the triangles round v, within the tangent plane or along the crease v lies on.
Eigen::Vector3d relaxed(const EditableMesh& mesh, int v, const Eigen::Vector3d& normal) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weight = 0;
  for (const int t : mesh.triangles_at(v)) {
    const double area = mesh.area_normal(t).norm();
    const Eigen::Vector3i& corners = mesh.triangle(t);
    sum += area * (mesh.position(corners[0]) + mesh.position(corners[1]) + mesh.position(corners[2])) / 3;
    weight += area;
  }
  if (weight <= 0) return mesh.position(v);
  const Eigen::Vector3d shift = sum / weight - mesh.position(v);
  const Crease crease = crease_at(mesh, v);
  if (crease.freedom == Freedom::none) return mesh.position(v);
  if (crease.freedom == Freedom::line) return mesh.position(v) + crease.along.dot(shift) * crease.along;
  return mesh.position(v) + shift - normal.dot(shift) * normal;
}

enum class Relaxing { no, yes };

/// Puts the vertices onto the surface, where that turns no triangle over; returns those that found no place.
std::vector<int> place(EditableMesh& mesh, const Projection& projection, const std::vector<int>& vertices,
                       Relaxing relaxing) {
  std::vector<NearSurface> points;
  for (const int v : vertices) {
    const Eigen::Vector3d normal = mesh.vertex_normal(v);
    points.push_back({relaxing == Relaxing::yes ? relaxed(mesh, v, normal) : mesh.position(v), normal});
  }
  const auto placed = projection(points);
  std::vector<int> lost;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (placed[i] && mesh.keeps_directions(vertices[i], *placed[i], relax_cosine))
      mesh.move(vertices[i], *placed[i]);
    else
      lost.push_back(vertices[i]);
  }
  return lost;
}

std::vector<int> movable_vertices(const EditableMesh& mesh) {
  std::vector<int> vertices;
  for (int v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.has_vertex(v) && !mesh.is_fixed(v)) vertices.push_back(v);
  return vertices;
}

void require_bearable(const TriangleMesh& mesh, const RemeshOptions& options) {
  const double triangles =
      measure(mesh).area_mm2 / (std::sqrt(3.0) / 4 * options.edge_length_mm * options.edge_length_mm);
  if (triangles <= options.most_triangles) return;
  throw GeometryError(mesh.name.empty() ? "surface" : mesh.name,
                      fmt::format("edges of {:g} mm make about {:.3g} triangles", options.edge_length_mm, triangles),
                      fmt::format("choose edges of {:.2g} mm or more",
                                  1.1 * options.edge_length_mm * std::sqrt(triangles / options.most_triangles)));
}

}  // namespace

RemeshedSurface remesh(const TriangleMesh& input, const RemeshOptions& options, const Progress& progress) {
  require_bearable(input, options);
  EditableMesh mesh(input);
  CreaseDrift drift(input.vertices_mm.size(), 0);
  const Projection onto_input = onto_mesh(input, options.edge_length_mm);
  for (int round = 0; round < options.iterations; ++round) {
    progress.report("remesh", static_cast<double>(round) / options.iterations);
    split_long_edges(mesh, longest_edge(options), drift);
    collapse_short_edges(mesh, options, drift);
    flip_towards_six(mesh);
    place(mesh, onto_input, movable_vertices(mesh), Relaxing::yes);
  }
  RemeshedSurface result;
  if (options.field != nullptr) {
    const Projection onto_field = onto_zero_set(*options.field, options.edge_length_mm / 2);
    place(mesh, onto_field, movable_vertices(mesh), Relaxing::yes);
    flip_towards_six(mesh);
    std::vector<int> lost = place(mesh, onto_field, movable_vertices(mesh), Relaxing::yes);
    lost = place(mesh, onto_field, lost, Relaxing::no);
    result.vertices_off_surface = lost.size();
  }
  progress.report("remesh", 1);
  result.mesh = mesh.compact();
  return result;
}

}  // namespace isostack
