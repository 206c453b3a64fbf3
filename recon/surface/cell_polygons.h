#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace isostack {

/// Numbering of a cubic cell. Corner c lies at (c & 1, c >> 1 & 1, c >> 2). Edge e runs from
/// corner cell_edges[e].low along axis cell_edges[e].axis.
struct CellEdge {
  int low;
  int axis;
};
extern const std::array<CellEdge, 12> cell_edges;

/// Closed polygons (as edge numbers) in which the zero set leaves one cell, given the values at
/// its corners (≥ 0 is inside). Ambiguous faces are decided by the sign of the bilinear saddle
/// (Nielson & Hamann 1991), from the face's four values only, so that neighbours agree and the
/// surface is closed. Polygons run counter-clockwise seen from outside.
std::vector<std::vector<int>> cell_polygons(const std::array<double, 8>& values);

/// Triangles (as indices into the polygon) without a diagonal inside a face of the cell, which
/// two neighbouring cells could both choose. Empty: none exists and the polygon needs a centre.
std::vector<std::array<int, 3>> triangulate_polygon(const std::vector<int>& polygon);

}  // namespace isostack
