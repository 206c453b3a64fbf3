#include "recon/subdivision/simplex_subdivision.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <vector>

#include "recon/subdivision/subdivision_levels.h"

namespace isostack {
namespace {

/// Two tetrahedra on both sides of a face whose corners they name in different orders.
Eigen::MatrixXi two_tetrahedra() {
  Eigen::MatrixXi simplices(4, 2);
  simplices.col(0) << 0, 1, 2, 3;
  simplices.col(1) << 3, 2, 1, 4;
  return simplices;
}

Eigen::MatrixXd their_corners() {
  Eigen::MatrixXd vertices(3, 5);
  vertices.col(0) << 0, 0, 0;
  vertices.col(1) << 1, 0, 0;
  vertices.col(2) << 0, 1, 0;
  vertices.col(3) << 0, 0, 1;
  vertices.col(4) << 0.9, 0.8, 1.1;
  return vertices;
}

double signed_volume(const Eigen::MatrixXd& vertices, const Eigen::VectorXi& t) {
  Eigen::Matrix3d sides;
  for (int i = 0; i < 3; ++i) sides.col(i) = vertices.col(t[i + 1]) - vertices.col(t[0]);
  return sides.determinant() / 6;
}

TEST(SimplexSubdivision, CutsATriangleIntoFourOfAQuarterInItsOrientation) {
  Eigen::MatrixXi triangle(3, 1);
  triangle << 0, 1, 2;
  Eigen::MatrixXd corners(2, 3);
  corners << 0, 4, 1, 0, 1, 5;
  const SimplexSubdivision step = subdivide(triangle, 3);
  const Eigen::MatrixXd vertices = midpoint_refined(corners, step);
  const std::vector<std::array<int, 2>> edges = {{0, 1}, {0, 2}, {1, 2}};
  EXPECT_EQ(step.edges, edges);
  ASSERT_EQ(step.simplices.cols(), 4);
  for (Eigen::Index s = 0; s < 4; ++s) {
    Eigen::Matrix2d sides;
    for (int i = 0; i < 2; ++i)
      sides.col(i) = vertices.col(step.simplices(i + 1, s)) - vertices.col(step.simplices(0, s));
    EXPECT_NEAR(sides.determinant() / 2, 19.0 / 2 / 4, 1e-12);  // the whole has (4 * 5 - 1 * 1) / 2; rounding
  }
}

TEST(SimplexSubdivision, CutsTetrahedraIntoEightOfAnEighthInTheirOrientation) {
  Eigen::MatrixXi simplices = two_tetrahedra();
  Eigen::MatrixXd vertices = their_corners();
  const double first = signed_volume(vertices, simplices.col(0)), second = signed_volume(vertices, simplices.col(1));
  for (int level = 1; level <= 3; ++level) {
    const SimplexSubdivision step = subdivide(simplices, vertices.cols());
    vertices = midpoint_refined(vertices, step);
    simplices = step.simplices;
    const Eigen::Index half = simplices.cols() / 2;
    for (Eigen::Index s = 0; s < simplices.cols(); ++s)
      EXPECT_NEAR(signed_volume(vertices, simplices.col(s)), (s < half ? first : second) / static_cast<double>(half),
                  1e-12);  // rounding
  }
}

TEST(SimplexSubdivision, NeighboursAgreeOnTheFaceBetweenThem) {
  const SimplexSubdivision once = subdivide(two_tetrahedra(), 5);
  const SimplexSubdivision twice = subdivide(once.simplices, 5 + static_cast<Eigen::Index>(once.edges.size()));
  std::map<std::array<int, 3>, int> faces;
  for (Eigen::Index s = 0; s < twice.simplices.cols(); ++s)
    for (int without = 0; without < 4; ++without) {
      std::array<int, 3> face{};
      for (int i = 0, k = 0; i < 4; ++i)
        if (i != without) face[static_cast<std::size_t>(k++)] = twice.simplices(i, s);
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  int outside = 0;
  for (const auto& [face, count] : faces) {
    EXPECT_LE(count, 2);
    outside += count == 1 ? 1 : 0;
  }
  EXPECT_EQ(outside, 6 * 16);  // the six outer faces, each cut into 4 twice
}

TEST(SimplexSubdivision, TetrahedraDoNotGrowThinner) {
  const Eigen::MatrixXi one = two_tetrahedra().leftCols(1);
  const SubdivisionLevels levels = subdivision_levels(one, 4, 4);
  Eigen::MatrixXd vertices = their_corners().leftCols(4);
  const auto worst_shape = [&](const Eigen::MatrixXi& simplices) {
    double worst = 1;
    for (Eigen::Index s = 0; s < simplices.cols(); ++s) {
      double longest = 0;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j)
          longest = std::max(longest, (vertices.col(simplices(i, s)) - vertices.col(simplices(j, s))).norm());
      worst = std::min(worst, signed_volume(vertices, simplices.col(s)) / (longest * longest * longest));
    }
    return worst;
  };
  std::vector<double> worst;
  for (int k = 0; k < 4; ++k) {
    vertices = midpoint_refined(vertices, levels.steps[static_cast<std::size_t>(k)]);
    worst.push_back(worst_shape(levels.simplices(k + 1)));
  }
  EXPECT_NEAR(worst[3], worst[1], 1e-12);  // there are three shapes, all of them after two steps; rounding
}

TEST(SubdivisionLevels, KnowWhereVerticesLieInTheBase) {
  const SubdivisionLevels levels = subdivision_levels(two_tetrahedra(), 5, 3);
  Eigen::MatrixXd vertices = their_corners();
  for (const SimplexSubdivision& step : levels.steps) vertices = midpoint_refined(vertices, step);
  const std::vector<BasePlace> places = base_places(levels);
  ASSERT_EQ(places.size(), static_cast<std::size_t>(vertices.cols()));
  for (std::size_t v = 0; v < places.size(); ++v) {
    Eigen::Vector3d place(0, 0, 0);
    double sum = 0;
    for (std::size_t i = 0; i < 4 && places[v].vertex[i] >= 0; ++i) {
      place += places[v].weight[i] * their_corners().col(places[v].vertex[i]);
      sum += places[v].weight[i];
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    EXPECT_NEAR((place - vertices.col(static_cast<Eigen::Index>(v))).norm(), 0, 1e-14);  // rounding
  }
}

TEST(SubdivisionLevels, RefineAChainOfEdges) {
  const SubdivisionLevels levels = subdivision_levels(two_tetrahedra(), 5, 2);
  Eigen::MatrixXd vertices = their_corners();
  for (const SimplexSubdivision& step : levels.steps) vertices = midpoint_refined(vertices, step);
  const std::vector<int> chain = refined_chain({2, 1}, levels, 0, 2);
  ASSERT_EQ(chain.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(
        (vertices.col(chain[i]) - Eigen::Vector3d(0.25 * static_cast<double>(i), 1 - 0.25 * static_cast<double>(i), 0))
            .norm(),
        0, 1e-15);
}

}  // namespace
}  // namespace isostack
