#include "recon/surface/cell_polygons.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace isostack {
namespace {

Eigen::Vector3d corner(int c) { return {double(c & 1), double(c >> 1 & 1), double(c >> 2 & 1)}; }

const CellEdge& edge(int e) { return cell_edges[static_cast<std::size_t>(e)]; }

/// Where the edge crosses zero, by linear interpolation.
Eigen::Vector3d crossing(int e, const std::array<double, 8>& values) {
  const int low = edge(e).low, high = low | 1 << edge(e).axis;
  const double a = values[static_cast<std::size_t>(low)], b = values[static_cast<std::size_t>(high)];
  return corner(low) + a / (a - b) * (corner(high) - corner(low));
}

bool is_crossed(int e, const std::array<double, 8>& values) {
  const int low = edge(e).low, high = low | 1 << edge(e).axis;
  return (values[static_cast<std::size_t>(low)] >= 0) != (values[static_cast<std::size_t>(high)] >= 0);
}

bool in_one_face(int a, int b) {
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const auto lies_in = [&](int e) { return edge(e).axis != axis && (edge(e).low >> axis & 1) == side; };
      if (lies_in(a) && lies_in(b)) return true;
    }
  return false;
}

/// Every sign pattern of the corners with several random magnitudes, which settle ambiguous faces both ways.
template <class Check>
void for_many_cells(Check check) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> size(0.05, 1);
  for (int pattern = 0; pattern < 256; ++pattern)
    for (int trial = 0; trial < 24; ++trial) {
      std::array<double, 8> values;
      for (int c = 0; c < 8; ++c) values[static_cast<std::size_t>(c)] = (pattern >> c & 1 ? 1 : -1) * size(random);
      check(values);
    }
}

TEST(CellEdges, AreTheTwelveOfACube) {
  std::set<std::pair<int, int>> different;
  for (const CellEdge& e : cell_edges) {
    EXPECT_EQ(e.low >> e.axis & 1, 0) << "the low corner is at the low end";
    different.insert({e.low, e.axis});
  }
  EXPECT_EQ(different.size(), 12u);
}

TEST(CellPolygons, PassEveryCrossedEdgeOnceFromFaceToFace) {
  for_many_cells([](const std::array<double, 8>& values) {
    std::vector<int> visits(12, 0);
    for (const std::vector<int>& polygon : cell_polygons(values)) {
      ASSERT_GE(polygon.size(), 3u);
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        ++visits[static_cast<std::size_t>(polygon[i])];
        ASSERT_TRUE(in_one_face(polygon[i], polygon[(i + 1) % polygon.size()]));
      }
    }
    for (int e = 0; e < 12; ++e) ASSERT_EQ(visits[static_cast<std::size_t>(e)], is_crossed(e, values) ? 1 : 0);
  });
}

TEST(CellPolygons, OfAPlaneFacesOutwardsWithTheRightArea) {
  std::mt19937 random(2);
  std::normal_distribution<double> gauss;
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Vector3d outwards = Eigen::Vector3d(gauss(random), gauss(random), gauss(random)).normalized();
    std::array<double, 8> values;
    for (int c = 0; c < 8; ++c)  // f > 0 inside; the plane passes the cell's middle
      values[static_cast<std::size_t>(c)] = -outwards.dot(corner(c) - Eigen::Vector3d(0.5, 0.5, 0.5));
    const auto polygons = cell_polygons(values);
    ASSERT_EQ(polygons.size(), 1u);
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    const Eigen::Vector3d start = crossing(polygons[0][0], values);
    for (std::size_t i = 1; i + 1 < polygons[0].size(); ++i)
      area += (crossing(polygons[0][i], values) - start).cross(crossing(polygons[0][i + 1], values) - start) / 2;
    EXPECT_LT((area.normalized() - outwards).norm(), 1e-9);
    EXPECT_GE(area.norm(), 1 - 1e-9);  // a cube's central cuts: from 1 (square) to √2 (diagonal)
    EXPECT_LE(area.norm(), std::sqrt(2.0) + 1e-9);
  }
}

TEST(CellPolygons, ZeroCountsAsInside) {
  std::array<double, 8> values;
  values.fill(0);
  EXPECT_TRUE(cell_polygons(values).empty());
  values[3] = -1;
  ASSERT_EQ(cell_polygons(values).size(), 1u);
  EXPECT_EQ(cell_polygons(values)[0].size(), 3u);
}

TEST(CellPolygons, AmbiguousFaceFollowsTheBilinearSaddle) {
  // Inside at two opposite corners of the face z = 0: joined when their product is larger.
  EXPECT_EQ(cell_polygons({2, -1, -1, 2, -9, -9, -9, -9}).size(), 1u);
  EXPECT_EQ(cell_polygons({1, -2, -2, 1, -9, -9, -9, -9}).size(), 2u);
}

TEST(CellPolygons, OfARandomFieldCloseUpAcrossCells) {
  constexpr int n = 9;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> nodes(n * n * n, -1);  // outside all round
  const auto at = [](int x, int y, int z) { return static_cast<std::size_t>((z * n + y) * n + x); };
  for (int z = 1; z < n - 1; ++z)
    for (int y = 1; y < n - 1; ++y)
      for (int x = 1; x < n - 1; ++x) nodes[at(x, y, z)] = uniform(random);
  std::map<std::pair<std::size_t, std::size_t>, int> uses;  // of directed sides between global edges
  for (int z = 0; z + 1 < n; ++z)
    for (int y = 0; y + 1 < n; ++y)
      for (int x = 0; x + 1 < n; ++x) {
        const auto node = [&](int c) { return at(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)); };
        std::array<double, 8> values;
        for (int c = 0; c < 8; ++c) values[static_cast<std::size_t>(c)] = nodes[node(c)];
        const auto global = [&](int e) { return node(edge(e).low) * 3 + static_cast<std::size_t>(edge(e).axis); };
        for (const std::vector<int>& polygon : cell_polygons(values))
          for (std::size_t i = 0; i < polygon.size(); ++i)
            ++uses[{global(polygon[i]), global(polygon[(i + 1) % polygon.size()])}];
      }
  ASSERT_GT(uses.size(), 1000u);
  for (const auto& [side, count] : uses) {
    const auto back = uses.find({side.second, side.first});
    ASSERT_NE(back, uses.end()) << "a side without a neighbour";
    ASSERT_EQ(count, back->second);
  }
}

TEST(TriangulatePolygon, CoversThePolygonWithoutDiagonalsInFaces) {
  std::size_t without = 0, all = 0;
  for_many_cells([&](const std::array<double, 8>& values) {
    for (const std::vector<int>& polygon : cell_polygons(values)) {
      ++all;
      const auto triangles = triangulate_polygon(polygon);
      if (triangles.empty()) {
        ++without;
        continue;
      }
      ASSERT_EQ(triangles.size(), polygon.size() - 2);
      const int n = static_cast<int>(polygon.size());
      std::map<std::pair<int, int>, int> sides;
      for (const auto& t : triangles)
        for (int s = 0; s < 3; ++s) ++sides[{t[static_cast<std::size_t>(s)], t[static_cast<std::size_t>((s + 1) % 3)]}];
      for (int i = 0; i < n; ++i) ASSERT_EQ((sides[{i, (i + 1) % n}]), 1) << "the outline keeps its direction";
      for (const auto& [side, count] : sides) {
        if (count == 0 || side.second == (side.first + 1) % n) continue;
        ASSERT_EQ(sides.count({side.second, side.first}), 1u) << "diagonals are shared by two triangles";
        ASSERT_FALSE(
            in_one_face(polygon[static_cast<std::size_t>(side.first)], polygon[static_cast<std::size_t>(side.second)]));
      }
    }
  });
  EXPECT_LT(without, all / 10) << "a centre vertex is the exception";
}

}  // namespace
}  // namespace isostack
