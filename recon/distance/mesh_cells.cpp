#include "recon/distance/mesh_cells.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "recon/metrics/point_triangle.h"

namespace isostack {

using Eigen::Vector3d;

namespace {

/// Below this share of its longest side's square a triangle's area is taken for none: its edges are as near as it is.
constexpr double least_area_share = 1e-10;

/// Across the triangle, as long as twice its area; zero for one without an area.
Vector3d normal_of(const TriangleMesh& mesh, int triangle) {
  const Vector3d& a = vertex_mm(mesh, corner(mesh, triangle, 0));
  const Vector3d ab = vertex_mm(mesh, corner(mesh, triangle, 1)) - a;
  const Vector3d ac = vertex_mm(mesh, corner(mesh, triangle, 2)) - a;
  const Vector3d normal = ab.cross(ac);
  const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
  return normal.norm() > least_area_share * longest ? normal : Vector3d::Zero();
}

/// Angles (about the edge) of what is nearest to an edge.
struct Sector {
  double low = 0, high = 2 * std::numbers::pi;
  bool whole = true;

  /// Leaves out what is nearer to a face that lies in this direction from the edge: keeps d·face <= 0.
  void leave_out(double face_angle) {
    constexpr double pi = std::numbers::pi;
    if (whole) {
      low = face_angle + pi / 2, high = face_angle + 3 * pi / 2, whole = false;
      first_ = face_angle;
      return;
    }
    const double turn = std::remainder(face_angle - first_, 2 * pi);  // in [-pi, pi]
    low = std::max(low, first_ + turn + pi / 2);
    high = std::min(high, first_ + turn + 3 * pi / 2);
  }

 private:
  double first_ = 0;
};

using ConvexPolygon = std::vector<Vector3d>;

ConvexPolygon side_of_cube(int side, double half) {
  ConvexPolygon square;
  for (const auto& [u, v] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}}) {
    Vector3d& corner = square.emplace_back();
    corner[side / 2] = side % 2 == 0 ? -half : half;
    corner[(side / 2 + 1) % 3] = u;
    corner[(side / 2 + 2) % 3] = v;
  }
  return square;
}

/// Keeps what has outward·x <= 0.
void clip(const Vector3d& outward, ConvexPolygon& polygon) {
  ConvexPolygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = outward.dot(a), at_b = outward.dot(b);
    if (at_a <= 0) kept.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  polygon.swap(kept);
}

}  // namespace

MeshCells::MeshCells(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid, double band_mm)
    : mesh_(mesh),
      topology_(topology),
      band_mm_(band_mm),
      faces_(static_cast<int>(mesh.triangles.size())),
      world_to_index_(grid.index_to_world.inverse()),
      band_in_k_(band_mm * world_to_index_.linear().row(2).norm()) {
  vertices_in_grid_.reserve(mesh.vertices_mm.size());
  for (const Vector3d& v : mesh.vertices_mm) vertices_in_grid_.push_back(world_to_index_ * v);
}

int MeshCells::triangle_of(int element) const {
  if (is_face(element)) return element;
  if (is_edge(element)) return topology_.sides_of_edge[edge_of(element)].front() / 3;
  return topology_.triangles_of_vertex[vertex_of(element)].front();
}

Eigen::Vector2d MeshCells::reach_in_k(int element) const {
  Eigen::Vector2d reach(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  const auto add = [&](int vertex) {
    const double k = in_grid(vertex).z();
    reach = {std::min(reach[0], k - band_in_k_), std::max(reach[1], k + band_in_k_)};
  };
  if (is_face(element)) {
    for (int i = 0; i < 3; ++i) add(corner(mesh_, element, i));
  } else if (is_edge(element)) {
    add(topology_.edges[static_cast<std::size_t>(edge_of(element))].low);
    add(topology_.edges[static_cast<std::size_t>(edge_of(element))].high);
  } else if (!topology_.triangles_of_vertex[vertex_of(element)].empty()) {
    add(vertex_of(element));
  }
  return reach;
}

void MeshCells::make(int element, ConvexCell& cell) const {
  cell.clear();
  if (is_face(element)) return make_prism(element, cell);
  if (is_edge(element)) return make_wedge(edge_of(element), cell);
  make_cone(vertex_of(element), cell);
}

void MeshCells::make_prism(int triangle, ConvexCell& cell) const {
  const Vector3d normal = normal_of(mesh_, triangle);
  if (normal.isZero(0)) return;
  const Vector3d up = world_to_index_.linear() * (normal * (band_mm_ / normal.norm()));
  const Vector3d& a = in_grid(corner(mesh_, triangle, 0));
  const Vector3d& b = in_grid(corner(mesh_, triangle, 1));
  const Vector3d& c = in_grid(corner(mesh_, triangle, 2));
  cell.add_face({a - up, b - up, c - up});
  cell.add_face({a + up, b + up, c + up});
  cell.add_face({a - up, b - up, b + up, a + up});
  cell.add_face({b - up, c - up, c + up, b + up});
  cell.add_face({c - up, a - up, a + up, c + up});
}

void MeshCells::make_wedge(int number, ConvexCell& cell) const {
  const MeshTopology::Edge& edge = topology_.edges[static_cast<std::size_t>(number)];
  const Vector3d along = (vertex_mm(mesh_, edge.high) - vertex_mm(mesh_, edge.low)).normalized();
  const Vector3d u = along.unitOrthogonal(), v = along.cross(u);
  Sector sector;
  for (const int side : topology_.sides_of_edge[number]) {
    if (normal_of(mesh_, side / 3).isZero(0)) continue;
    const Vector3d into = vertex_mm(mesh_, corner(mesh_, side / 3, side % 3 + 2)) - vertex_mm(mesh_, edge.low);
    sector.leave_out(std::atan2(v.dot(into), u.dot(into)));
  }
  const double angle = sector.high - sector.low;
  if (!(angle > 1e-12)) return;
  // The sector of a disc lies in the polygon of tangents, one for every 60 degrees or less.
  const int tangents = static_cast<int>(std::ceil(angle / (std::numbers::pi / 3)));
  const auto spoke = [&](double at, double length) {
    return (world_to_index_.linear() * (length * (std::cos(at) * u + std::sin(at) * v))).eval();
  };
  std::vector<Vector3d> outline{spoke(sector.low, band_mm_)};
  for (int t = 0; t < tangents; ++t)
    outline.push_back(spoke(sector.low + angle * (t + 0.5) / tangents, band_mm_ / std::cos(0.5 * angle / tangents)));
  outline.push_back(spoke(sector.high, band_mm_));
  if (!sector.whole) outline.push_back(Vector3d::Zero());
  const Vector3d &a = in_grid(edge.low), &b = in_grid(edge.high);
  for (const Vector3d* end : {&a, &b}) {
    for (const Vector3d& corner : outline) cell.add_corner(*end + corner);
    cell.end_face();
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector3d &p = outline[i], &q = outline[(i + 1) % outline.size()];
    cell.add_face({a + p, a + q, b + q, b + p});
  }
}

void MeshCells::make_cone(int vertex, ConvexCell& cell) const {
  const Vector3d& apex = in_grid(vertex);
  // The cone's part of each side of a cube round the band, and the pyramid under it.
  for (int side = 0; side < 6; ++side) {
    ConvexPolygon polygon = side_of_cube(side, band_mm_);
    for (const int number : topology_.edges_of_vertex[vertex]) {
      const MeshTopology::Edge& edge = topology_.edges[static_cast<std::size_t>(number)];
      const int other = edge.low == vertex ? edge.high : edge.low;
      clip(vertex_mm(mesh_, other) - vertex_mm(mesh_, vertex), polygon);
      if (polygon.empty()) break;
    }
    for (Vector3d& corner : polygon) corner = apex + world_to_index_.linear() * corner;
    for (const Vector3d& corner : polygon) cell.add_corner(corner);
    if (!polygon.empty()) cell.end_face();
    for (std::size_t i = 0; i < polygon.size(); ++i)
      cell.add_face({apex, polygon[i], polygon[(i + 1) % polygon.size()]});
  }
}

ElementDistance::ElementDistance(const TriangleMesh& mesh, const MeshTopology& topology, const MeshCells& cells,
                                 int element) {
  if (cells.is_face(element)) {
    kind_ = Kind::face;
    a_ = vertex_mm(mesh, corner(mesh, element, 0));
    ab_ = vertex_mm(mesh, corner(mesh, element, 1)) - a_;
    ac_ = vertex_mm(mesh, corner(mesh, element, 2)) - a_;
    normal_ = ab_.cross(ac_).normalized();
    d00_ = ab_.squaredNorm(), d01_ = ab_.dot(ac_), d11_ = ac_.squaredNorm();
    inverse_ = 1 / (d00_ * d11_ - d01_ * d01_);
  } else if (cells.is_edge(element)) {
    kind_ = Kind::edge;
    const MeshTopology::Edge& edge = topology.edges[static_cast<std::size_t>(cells.edge_of(element))];
    a_ = vertex_mm(mesh, edge.low);
    ab_ = vertex_mm(mesh, edge.high) - a_;
    inverse_ = 1 / ab_.squaredNorm();
  } else {
    a_ = vertex_mm(mesh, cells.vertex_of(element));
  }
}

double ElementDistance::squared_mm2(const Vector3d& point_mm) const {
  const Vector3d ap = point_mm - a_;
  if (kind_ == Kind::vertex) return ap.squaredNorm();
  const double along = ap.dot(ab_);
  if (kind_ == Kind::edge) return (ap - std::clamp(along * inverse_, 0.0, 1.0) * ab_).squaredNorm();
  const double across = ap.dot(ac_);
  const double v = (d11_ * along - d01_ * across) * inverse_, w = (d00_ * across - d01_ * along) * inverse_;
  if (v >= 0 && w >= 0 && v + w <= 1) {
    const double height = ap.dot(normal_);
    return height * height;
  }
  return (closest_point_on_triangle({a_, a_ + ab_, a_ + ac_}, point_mm) - point_mm).squaredNorm();
}

}  // namespace isostack
