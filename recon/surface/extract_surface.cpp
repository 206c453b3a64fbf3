#include "recon/surface/extract_surface.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <unordered_map>
#include <unordered_set>

#include "recon/geometry/errors.h"
#include "recon/surface/cell_polygons.h"
#include "recon/surface/cut_field.h"
#include "recon/surface/lattice.h"
#include "recon/surface/root_finding.h"

namespace isostack {

namespace {

using Key = CubicLattice::Key;

bool is_crossed(const std::array<double, 8>& values) {
  const auto inside = [](double value) { return value >= 0; };
  return std::any_of(values.begin(), values.end(), inside) && !std::all_of(values.begin(), values.end(), inside);
}

/// Whether the four corners of the face at `side` (0, 1) of `axis` differ in sign.
bool face_is_crossed(const std::array<double, 8>& values, int axis, int side) {
  int inside = 0;
  for (int corner = 0; corner < 8; ++corner)
    if ((corner >> axis & 1) == side && values[static_cast<std::size_t>(corner)] >= 0) ++inside;
  return inside != 0 && inside != 4;
}

std::vector<Key> cells_around(const CubicLattice& lattice, const Eigen::Vector3d& seed_mm) {
  std::vector<Key> cells;
  const Eigen::Vector3i centre = CubicLattice::node(lattice.cell_containing(seed_mm));
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const Eigen::Vector3i cell = centre + Eigen::Vector3i(i, j, k);
        if ((cell.array() >= 0).all() && lattice.contains_cell(CubicLattice::key(cell)))
          cells.push_back(CubicLattice::key(cell));
      }
  return cells;
}

/// Breadth first from the seeds' cells through crossed faces; returns the crossed cells in order.
std::vector<Key> follow_surface(CubicLattice& lattice, const ScalarField& field,
                                const std::vector<Eigen::Vector3d>& seeds_mm, const Progress& progress) {
  std::vector<Key> crossed, front;
  std::unordered_set<Key> seen;
  for (const Eigen::Vector3d& seed : seeds_mm)
    for (const Key cell : cells_around(lattice, seed))
      if (seen.insert(cell).second) front.push_back(cell);
  for (double wave = 0; !front.empty(); ++wave) {
    progress.report("surface", 0.8 * wave / (wave + 20));
    lattice.evaluate_corners(front, field);
    std::vector<Key> next;
    for (const Key cell : front) {
      const std::array<double, 8> values = lattice.corner_values(cell);
      if (!is_crossed(values)) continue;
      crossed.push_back(cell);
      for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
          if (!face_is_crossed(values, axis, side)) continue;
          const Key neighbour = CubicLattice::neighbour(cell, axis, side == 0 ? -1 : 1);
          if (lattice.contains_cell(neighbour) && seen.insert(neighbour).second) next.push_back(neighbour);
        }
    }
    front = std::move(next);
  }
  return crossed;
}

/// Gathers vertices (one per crossed lattice edge, plus polygon centres) and triangles.
class MeshBuilder {
 public:
  explicit MeshBuilder(const CubicLattice& lattice) : lattice_(lattice) {}

  void add_cell(Key cell) {
    for (const std::vector<int>& polygon : cell_polygons(lattice_.corner_values(cell))) {
      std::vector<int> vertices;
      for (const int edge : polygon) vertices.push_back(vertex_on(cell, edge));
      const auto triangles = triangulate_polygon(polygon);
      for (const auto& t : triangles) add_triangle(at(vertices, t[0]), at(vertices, t[1]), at(vertices, t[2]));
      if (triangles.empty()) add_fan_about_centre(vertices);
    }
  }

  /// Puts every vertex on f = 0 and takes the normals from the gradient.
  TriangleMesh finish(const ScalarField& field, double tolerance) {
    mesh_.vertices_mm = roots_on_segments(field, segments_, tolerance);
    for (const std::vector<int>& ring : centres_) {
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      for (const int v : ring) centre += mesh_.vertices_mm[static_cast<std::size_t>(v)];
      mesh_.vertices_mm.push_back(centre / static_cast<double>(ring.size()));
    }
    for (Eigen::Vector3i& triangle : mesh_.triangles)  // centres were numbered from the back
      for (int& v : triangle)
        if (v < 0) v = static_cast<int>(segments_.size()) - 1 - v;
    const Eigen::Map<const Eigen::Matrix3Xd> points(mesh_.vertices_mm.front().data(), 3,
                                                    static_cast<Eigen::Index>(mesh_.vertices_mm.size()));
    const Eigen::Matrix3Xd gradients = field.gradients(points);
    for (Eigen::Index i = 0; i < gradients.cols(); ++i) mesh_.normals.push_back(-gradients.col(i).stableNormalized());
    return std::move(mesh_);
  }

 private:
  static int at(const std::vector<int>& vertices, int i) { return vertices[static_cast<std::size_t>(i)]; }

  int vertex_on(Key cell, int edge_number) {
    const CellEdge& edge = cell_edges[static_cast<std::size_t>(edge_number)];
    const Key low = cell + CubicLattice::key({edge.low & 1, edge.low >> 1 & 1, edge.low >> 2});
    auto& vertices = vertex_of_edge_[static_cast<std::size_t>(edge.axis)];
    const auto [entry, is_new] = vertices.emplace(low, static_cast<int>(segments_.size()));
    if (is_new) {
      const Key high = CubicLattice::neighbour(low, edge.axis, 1);
      segments_.push_back(
          {lattice_.position_mm(low), lattice_.position_mm(high), lattice_.value(low), lattice_.value(high)});
    }
    return entry->second;
  }

  void add_triangle(int a, int b, int c) { mesh_.triangles.emplace_back(a, b, c); }

  void add_fan_about_centre(const std::vector<int>& ring) {
    centres_.push_back(ring);
    const int centre = -static_cast<int>(centres_.size());
    for (std::size_t i = 0; i < ring.size(); ++i) add_triangle(ring[i], ring[(i + 1) % ring.size()], centre);
  }

  const CubicLattice& lattice_;
  TriangleMesh mesh_;
  std::array<std::unordered_map<Key, int>, 3> vertex_of_edge_;
  std::vector<CrossedSegment> segments_;
  std::vector<std::vector<int>> centres_;
};

std::vector<std::size_t> untouched(const CubicLattice& lattice, const std::vector<Eigen::Vector3d>& seeds_mm,
                                   const std::vector<Key>& crossed) {
  const std::unordered_set<Key> crossed_set(crossed.begin(), crossed.end());
  std::vector<std::size_t> seeds;
  for (std::size_t i = 0; i < seeds_mm.size(); ++i) {
    const std::vector<Key> cells = cells_around(lattice, seeds_mm[i]);
    if (std::none_of(cells.begin(), cells.end(), [&](Key cell) { return crossed_set.contains(cell); }))
      seeds.push_back(i);
  }
  return seeds;
}

}  // namespace

ExtractedSurface extract_surface(const ScalarField& field, const std::vector<Eigen::Vector3d>& seeds_mm,
                                 const ExtractionOptions& options, const Progress& progress) {
  ExtractedSurface result;
  const auto was_cut = std::make_shared<bool>(false);
  const ScalarField cut_field =
      cut_to_bounds(field, {options.bounds, options.half_spaces, 1e-3 * options.resolution_mm}, was_cut);
  CubicLattice lattice(options.bounds, options.resolution_mm);
  const std::vector<Key> crossed = follow_surface(lattice, cut_field, seeds_mm, progress);
  if (crossed.empty() && options.may_be_empty) return result;
  if (crossed.empty())
    throw GeometryError("surface", "the function has no zero set near the contours",
                        "check the contours or give a finer --resolution");

  MeshBuilder builder(lattice);
  for (const Key cell : crossed) builder.add_cell(cell);
  progress.report("surface", 0.85);
  result.mesh = builder.finish(cut_field, options.vertex_tolerance);
  result.seeds_without_surface = untouched(lattice, seeds_mm, crossed);
  result.cut_by_bounds = *was_cut;
  progress.report("surface", 1.0);
  return result;
}

}  // namespace isostack
