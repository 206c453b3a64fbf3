#include "recon/subdivision/base_tetrahedra.h"

#include <gtest/gtest.h>

#include <random>

#include "recon/subdivision/base_mesh.h"
#include "tests/support/tetrahedra.h"

namespace isostack {
namespace {

using testing_support::count;
using testing_support::TetrahedraCount;

std::vector<Eigen::Vector3d> random_directions(std::mt19937& random, std::size_t number) {
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3d> directions;
  while (directions.size() < number)
    directions.push_back(Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized());
  return directions;
}

/// Surface × [0, 1] has the surface's Euler characteristic, and its border is the surface twice.
void expect_slab(const Eigen::MatrixXi& tetrahedra, const DomainMesh& first, const DomainMesh& second, long euler) {
  const TetrahedraCount counted = count(tetrahedra);
  EXPECT_EQ(counted.euler_characteristic, euler);
  EXPECT_EQ(counted.crowded_triangles, 0u);
  EXPECT_EQ(counted.bad_links, 0u);
  EXPECT_EQ(counted.open_triangles, first.triangles.size() + second.triangles.size());
}

TEST(BaseTetrahedra, BetweenAnyTwoMeshesOfTheSphere) {
  std::mt19937 random(3);
  for (std::size_t i = 0; i < 40; ++i) {
    const DomainMesh first = sphere_base(random_directions(random, 1 + i % 20));
    const DomainMesh second = sphere_base(random_directions(random, 1 + 7 * i % 23));
    expect_slab(base_tetrahedra(first, second), first, second, 2);
  }
}

TEST(BaseTetrahedra, EveryRuleIsUsed) {
  const DomainMesh first = sphere_base({}), second = sphere_base({Eigen::Vector3d(1, 2, 3).normalized()});
  const Eigen::MatrixXi tetrahedra = base_tetrahedra(first, second);
  std::array<std::size_t, 4> with{};  // vertices of `first`
  for (Eigen::Index t = 0; t < tetrahedra.cols(); ++t)
    ++with[static_cast<std::size_t>((tetrahedra.col(t).array() < static_cast<int>(first.positions.size())).count())];
  EXPECT_EQ(with[1], second.triangles.size());  // rule (a): every triangle of the second once
  EXPECT_EQ(with[3], first.triangles.size());   // rule (c)
  EXPECT_GT(with[2], 0u);                       // rule (b)
}

TEST(BaseTetrahedra, RegularSolidsInSpecialPosition) {
  const std::vector<Eigen::Vector3d> octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const DomainMesh coarse = sphere_base(octahedron, {.vertices = 6, .widest_gap_degrees = 60});
  ASSERT_EQ(coarse.triangles.size(), 8u);
  expect_slab(base_tetrahedra(coarse, coarse), coarse, coarse, 2);
  expect_slab(base_tetrahedra(coarse, sphere_base({})), coarse, sphere_base({}), 2);
}

TEST(BaseTetrahedra, OfATorus) {
  for (const Eigen::Vector2i& around : {Eigen::Vector2i(4, 4), Eigen::Vector2i(4, 6), Eigen::Vector2i(7, 5)}) {
    const DomainMesh base = torus_base(around);
    ASSERT_EQ(base.triangles.size(), 2 * base.positions.size());
    expect_slab(base_tetrahedra(base, base), base, base, 0);
  }
}

/// A point of the second mesh at the place of one of the first is joined to it, so that features become edges.
TEST(BaseTetrahedra, JoinsWhatIsAtOnePlace) {
  std::mt19937 random(5);
  for (int i = 0; i < 20; ++i) {
    std::vector<Eigen::Vector3d> first = random_directions(random, 5), second = random_directions(random, 9);
    second[2] = first[3];
    const DomainMesh a = sphere_base(first), b = sphere_base(second);
    const Eigen::MatrixXi tetrahedra = base_tetrahedra(a, b);
    const int to = static_cast<int>(a.positions.size()) + 2;
    bool are_joined = false;
    for (Eigen::Index t = 0; t < tetrahedra.cols(); ++t)
      are_joined |= (tetrahedra.col(t).array() == 3).any() && (tetrahedra.col(t).array() == to).any();
    EXPECT_TRUE(are_joined);
  }
}

}  // namespace
}  // namespace isostack
