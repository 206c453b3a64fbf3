#include "recon/constraints/mesh_constraints.h"

#include <gtest/gtest.h>

#include "tests/support/morph_meshes.h"

namespace isostack {
namespace {

using testing_support::box_mesh;
using testing_support::sphere_mesh;
using testing_support::together;

constexpr double radius_mm = 40;

TriangleMesh sphere() { return sphere_mesh(Eigen::Vector3d(5, -3, 9), radius_mm, 128, 64); }

TEST(MeshConstraints, ValuesAreSignedDistancesPositiveInside) {
  const TriangleMesh mesh = sphere();
  const auto samples = spread_samples(mesh, {.max_samples = 200});
  const ConstraintSet set = mesh_constraints(mesh, samples, {.offset_mm = 2});
  ASSERT_EQ(set.values.size(), 3 * static_cast<Eigen::Index>(samples.size()));
  for (Eigen::Index i = 0; i < set.values.size(); ++i) {
    const double inside_mm = radius_mm - (set.points.col(i) - Eigen::Vector3d(5, -3, 9)).norm();
    EXPECT_NEAR(set.values[i], inside_mm, 0.06);  // the mesh's chords
    EXPECT_EQ(set.values[i] == 0, i < static_cast<Eigen::Index>(samples.size()));
  }
}

TEST(MeshConstraints, PartnersStayInsideAThinPlateAndInsideAThinGap) {
  // Plates 0.5 mm thick, 0.5 mm apart; partners 4 mm off would lie beyond all of them.
  const TriangleMesh mesh = together(box_mesh({0, 0, 0}, {20, 20, 0.5}), box_mesh({0, 0, 1}, {20, 20, 1.5}));
  const auto samples = spread_samples(mesh, {.max_samples = 600});
  const ConstraintSet set = mesh_constraints(mesh, samples, {.offset_mm = 4});
  int inside = 0, in_gap = 0;
  for (auto i = static_cast<Eigen::Index>(samples.size()); i < set.values.size(); ++i) {
    const Eigen::Vector3d p = set.points.col(i);
    const bool in_plates = p.x() > 0 && p.x() < 20 && p.y() > 0 && p.y() < 20 &&
                           ((p.z() > 0 && p.z() < 0.5) || (p.z() > 1 && p.z() < 1.5));
    EXPECT_EQ(set.values[i] > 0, in_plates) << p.transpose();
    inside += in_plates;
    in_gap += !in_plates && p.z() > 0.5 && p.z() < 1;
  }
  EXPECT_GT(inside, 500);  // most samples have a partner, though a nearer one
  EXPECT_GT(in_gap, 200);
}

TEST(MeshConstraints, ThePapersRecipeHasValueOneAtTheOffset) {
  const TriangleMesh mesh = sphere();
  const auto samples = vertex_samples(mesh);
  ASSERT_EQ(samples.size(), mesh.vertices_mm.size());
  const ConstraintSet set = mesh_constraints(mesh, samples, {.offset_mm = 0.8, .as_in_paper = true});
  const auto count = static_cast<Eigen::Index>(samples.size());
  ASSERT_EQ(set.values.size(), 2 * count);
  EXPECT_EQ(set.values.head(count), Eigen::VectorXd::Zero(count));
  EXPECT_EQ(set.values.tail(count), Eigen::VectorXd::Ones(count));
  for (Eigen::Index i = 0; i < count; ++i)
    EXPECT_NEAR((set.points.col(count + i) - Eigen::Vector3d(5, -3, 9)).norm(), radius_mm - 0.8, 1e-3);
}

}  // namespace
}  // namespace isostack
