#include "recon/surface/lattice.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

Eigen::AlignedBox3d box() { return {Eigen::Vector3d(-3, 10, 100), Eigen::Vector3d(7, 12.5, 101)}; }

TEST(Lattice, KeysRoundTripAndStep) {
  const int far = (1 << 20) - 1;
  for (const Eigen::Vector3i& node : {Eigen::Vector3i(0, 0, 0), Eigen::Vector3i(1, 2, 3), Eigen::Vector3i(far, 5, far)})
    EXPECT_EQ(CubicLattice::node(CubicLattice::key(node)), node);
  const CubicLattice::Key key = CubicLattice::key({10, 20, 30});
  EXPECT_EQ(CubicLattice::node(CubicLattice::neighbour(key, 0, -1)), Eigen::Vector3i(9, 20, 30));
  EXPECT_EQ(CubicLattice::node(CubicLattice::neighbour(key, 1, 2)), Eigen::Vector3i(10, 22, 30));
  EXPECT_EQ(CubicLattice::node(CubicLattice::neighbour(key, 2, -30)), Eigen::Vector3i(10, 20, 0));
}

TEST(Lattice, CoversTheBoxAndACellMore) {
  const double spacing = 0.8;
  const CubicLattice lattice(box(), spacing);
  for (int c = 0; c < 8; ++c) {
    const auto corner = box().corner(static_cast<Eigen::AlignedBox3d::CornerType>(c));
    const CubicLattice::Key cell = lattice.cell_containing(corner);
    const Eigen::Vector3d offset = corner - lattice.position_mm(cell);
    EXPECT_GE(offset.minCoeff(), -1e-9);
    EXPECT_LE(offset.maxCoeff(), spacing + 1e-9);
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) EXPECT_TRUE(lattice.contains_cell(CubicLattice::neighbour(cell, axis, step)));
  }
}

TEST(Lattice, StepsBeyondItsEndsAreOutside) {
  const CubicLattice lattice(box(), 0.8);
  const CubicLattice::Key first = CubicLattice::key({0, 0, 0});
  EXPECT_TRUE(lattice.contains_cell(first));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_FALSE(lattice.contains_cell(CubicLattice::neighbour(first, axis, -1))) << axis;
    CubicLattice::Key cell = first;
    int cells = 0;
    for (; lattice.contains_cell(cell); cell = CubicLattice::neighbour(cell, axis, 1)) ++cells;
    const double length = box().sizes()[axis];
    EXPECT_GE(cells * 0.8, length + 1.6 - 1e-9);
    EXPECT_LE(cells * 0.8, length + 2.4 + 1e-9);
  }
}

TEST(Lattice, PointsOutsideGoToTheNearestCell) {
  const CubicLattice lattice(box(), 0.8);
  EXPECT_EQ(lattice.cell_containing({-1e5, -1e5, -1e5}), CubicLattice::key({0, 0, 0}));
  EXPECT_TRUE(lattice.contains_cell(lattice.cell_containing({1e5, 1e5, 1e5})));
}

TEST(Lattice, EvaluatesEachNodeOnceAtItsPlace) {
  CubicLattice lattice(box(), 0.8);
  std::size_t evaluated = 0;
  ScalarField field;
  field.values = [&](const Eigen::Matrix3Xd& points) -> Eigen::VectorXd {
    evaluated += static_cast<std::size_t>(points.cols());
    return (points.row(0) + 10 * points.row(1) + 100 * points.row(2)).transpose();
  };
  const CubicLattice::Key cell = lattice.cell_containing({0, 11, 100.5}), next = CubicLattice::neighbour(cell, 0, 1);
  lattice.evaluate_corners({cell}, field);
  EXPECT_EQ(evaluated, 8u);
  lattice.evaluate_corners({cell, next}, field);
  EXPECT_EQ(evaluated, 12u);  // the shared face is known
  const auto values = lattice.corner_values(next);
  for (int c = 0; c < 8; ++c) {
    const Eigen::Vector3d at = lattice.position_mm(next) + 0.8 * Eigen::Vector3d(c & 1, c >> 1 & 1, c >> 2);
    EXPECT_NEAR(values[static_cast<std::size_t>(c)], at.x() + 10 * at.y() + 100 * at.z(), 1e-8);
  }
}

TEST(Lattice, RefusesResolutionsItCannotAddress) {
  EXPECT_THROW(CubicLattice(box(), 1e-6), GeometryError);
  EXPECT_THROW(CubicLattice(box(), 0), GeometryError);
  EXPECT_THROW(CubicLattice(box(), -1), GeometryError);
}

}  // namespace
}  // namespace isostack
