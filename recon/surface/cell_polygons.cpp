#include "recon/surface/cell_polygons.h"

#include <cstddef>

namespace isostack {

const std::array<CellEdge, 12> cell_edges = {
    {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {0, 1}, {1, 1}, {4, 1}, {5, 1}, {0, 2}, {1, 2}, {2, 2}, {3, 2}}};

namespace {

/// Corners of each face, counter-clockwise seen from outside the cell.
constexpr std::array<std::array<int, 4>, 6> face_corners = {
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

int edge_between(int corner_a, int corner_b) {
  const int low = corner_a & corner_b;
  const int axis = (corner_a ^ corner_b) >> 1;  // 1, 2, 4 -> 0, 1, 2
  for (int e = 0; e < 12; ++e)
    if (cell_edges[static_cast<std::size_t>(e)].low == low && cell_edges[static_cast<std::size_t>(e)].axis == axis)
      return e;
  return -1;
}

bool share_a_face(int edge_a, int edge_b) {
  const CellEdge& a = cell_edges[static_cast<std::size_t>(edge_a)];
  const CellEdge& b = cell_edges[static_cast<std::size_t>(edge_b)];
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == a.axis || axis == b.axis) continue;  // an edge lies in faces across the other axes
    if (((a.low >> axis) & 1) == ((b.low >> axis) & 1)) return true;
  }
  return false;
}

/// successor[e] = the edge to which the polygon goes on from e; -1 where e is not crossed.
/// Walking counter-clockwise round a face, every segment starts where the walk enters the inside
/// and ends where it leaves it; the neighbouring face sees the same edge the other way round.
void link_face(const std::array<int, 4>& corners, const std::array<double, 8>& values, std::array<int, 12>& successor) {
  std::array<double, 4> value{};
  std::array<int, 4> edge{};
  for (std::size_t c = 0; c < 4; ++c) {
    value[c] = values[static_cast<std::size_t>(corners[c])];
    edge[c] = edge_between(corners[c], corners[(c + 1) % 4]);
  }
  const auto leaves = [&](std::size_t c) { return value[c] >= 0 && value[(c + 1) % 4] < 0; };
  const auto enters = [&](std::size_t c) { return value[c] < 0 && value[(c + 1) % 4] >= 0; };

  const bool ambiguous =
      (value[0] >= 0) == (value[2] >= 0) && (value[1] >= 0) == (value[3] >= 0) && (value[0] >= 0) != (value[1] >= 0);
  const double even = value[0] * value[2], odd = value[1] * value[3];
  const bool inside_connected = value[0] >= 0 ? even > odd : odd > even;
  for (std::size_t c = 0; c < 4; ++c) {
    if (!enters(c)) continue;
    // Segments round an inside corner end at the next edge; round an outside corner at the previous one.
    std::size_t other = (c + 1) % 4;
    if (ambiguous)
      other = inside_connected ? (c + 3) % 4 : (c + 1) % 4;
    else
      while (!leaves(other)) other = (other + 1) % 4;
    successor[static_cast<std::size_t>(edge[c])] = edge[other];
  }
}

bool fan_is_free_of_face_diagonals(const std::vector<int>& polygon, std::size_t apex) {
  const std::size_t n = polygon.size();
  for (std::size_t step = 2; step + 1 < n; ++step)
    if (share_a_face(polygon[apex], polygon[(apex + step) % n])) return false;
  return true;
}

}  // namespace

std::vector<std::vector<int>> cell_polygons(const std::array<double, 8>& values) {
  std::array<int, 12> successor;
  successor.fill(-1);
  for (const auto& corners : face_corners) link_face(corners, values, successor);

  std::vector<std::vector<int>> polygons;
  for (int start = 0; start < 12; ++start) {
    if (successor[static_cast<std::size_t>(start)] < 0) continue;
    std::vector<int> polygon;
    for (int e = start; successor[static_cast<std::size_t>(e)] >= 0;) {
      polygon.push_back(e);
      const int next = successor[static_cast<std::size_t>(e)];
      successor[static_cast<std::size_t>(e)] = -1;
      e = next;
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

std::vector<std::array<int, 3>> triangulate_polygon(const std::vector<int>& polygon) {
  const std::size_t n = polygon.size();
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t apex = 0; apex < n; ++apex) {
    if (!fan_is_free_of_face_diagonals(polygon, apex)) continue;
    for (std::size_t step = 1; step + 1 < n; ++step)
      triangles.push_back(
          {static_cast<int>(apex), static_cast<int>((apex + step) % n), static_cast<int>((apex + step + 1) % n)});
    break;
  }
  return triangles;
}

}  // namespace isostack
