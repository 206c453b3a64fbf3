#include "recon/surface/zero_contours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

PlaneFunction each(double (*value)(const Eigen::Vector2d&)) {
  return [value](const Eigen::Matrix2Xd& points) {
    Eigen::VectorXd values(points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) values[i] = value(points.col(i));
    return values;
  };
}

std::vector<Contour> traced(const PlaneFunction& function, const PlaneLattice& lattice, double deviation_mm) {
  return zero_contours(function, lattice, function(nodes_of(lattice)), deviation_mm);
}

const PlaneLattice over_square = lattice_over({Eigen::Vector2d(-10, -10), Eigen::Vector2d(10, 10)}, 1);

// Far from linear between nodes a lattice step apart: linear interpolation would be 0.1 off.
double steep_disc(const Eigen::Vector2d& p) { return std::exp(2 * (7 - p.norm())) - 1; }
double ring(const Eigen::Vector2d& p) { return 2 - std::abs(p.norm() - 6); }

TEST(ZeroContours, PointsAreRootsOfTheFunction) {
  const auto contours = traced(each(steep_disc), over_square, 0.001);
  ASSERT_EQ(contours.size(), 1u);
  for (const Eigen::Vector2d& point : contours.front().points_mm)
    EXPECT_NEAR(point.norm(), 7, 2e-6);  // the roots' tolerance is a millionth of a step, some are on diagonals
}

TEST(ZeroContours, ChordsStayWithinTheDeviation) {
  for (const double deviation_mm : {0.1, 0.01, 0.001}) {
    const auto points = traced(each(steep_disc), over_square, deviation_mm).front().points_mm;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d middle = (points[i] + points[(i + 1) % points.size()]) / 2;
      EXPECT_LE(7 - middle.norm(), deviation_mm + 2e-6);
    }
  }
}

/// A wedge of 37° whose tip lies between nodes: the lattice's lines leave it 0.64 mm before its end.
double wedge(const Eigen::Vector2d& p) { return std::min((7.3 - p.x()) / 3 - std::abs(p.y() - 0.2), p.x() + 5); }

TEST(ZeroContours, TipsNarrowerThanTheLatticeAreFollowed) {
  double tip = 0;
  const auto contours = traced(each(wedge), over_square, 0.01);
  for (const Eigen::Vector2d& point : contours.front().points_mm) tip = std::max(tip, point.x());
  EXPECT_NEAR(tip, 7.3, 0.15);  // a last chord beside the tip may be straight in its middle
}

TEST(ZeroContours, AHoleRunsTheOtherWay) {
  const auto contours = traced(each(ring), over_square, 0.001);
  ASSERT_EQ(contours.size(), 2u);
  EXPECT_EQ(contours[0].depth, 0);
  EXPECT_EQ(contours[1].depth, 1);
  // Inscribed polygons whose chords are a thousandth of a mm inside: less area by at most length · 2/3 · deviation.
  EXPECT_NEAR(signed_area_mm2(contours[0]), 64 * std::numbers::pi, 0.04);
  EXPECT_NEAR(signed_area_mm2(contours[1]), -16 * std::numbers::pi, 0.02);
}

TEST(ZeroContours, ANegativeValueTooSmallForAFloatIsOutside) {
  const PlaneFunction everywhere_outside = [](const Eigen::Matrix2Xd& points) {
    return Eigen::VectorXd::Constant(points.cols(), -1e-60).eval();
  };
  EXPECT_TRUE(traced(everywhere_outside, over_square, 0.01).empty());
}

TEST(ZeroContours, WhatTheLatticeCutsIsClosedBeyondItsRim) {
  const PlaneLattice small = lattice_over({Eigen::Vector2d(-4, -4), Eigen::Vector2d(4, 4)}, 1);
  const PlaneFunction function = each(steep_disc);
  EXPECT_TRUE(is_cut(small, function(nodes_of(small))));
  EXPECT_FALSE(is_cut(over_square, function(nodes_of(over_square))));
  ASSERT_EQ(traced(function, small, 0.01).size(), 1u);
}

TEST(ZeroContours, TooFineALatticeIsRefused) {
  EXPECT_THROW(lattice_over({Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)}, 1e-6), GeometryError);
}

}  // namespace
}  // namespace isostack
