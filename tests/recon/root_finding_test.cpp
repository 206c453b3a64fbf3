#include "recon/surface/root_finding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/analytic_shapes.h"

namespace isostack {
namespace {

using testing_support::field_of;

CrossedSegment segment(const std::function<double(const Eigen::Vector3d&)>& f, const Eigen::Vector3d& from,
                       const Eigen::Vector3d& to) {
  return {from, to, f(from), f(to)};
}

TEST(RootsOnSegments, LieOnTheSphere) {
  const auto sphere = [](const Eigen::Vector3d& p) { return 10 - p.norm(); };
  std::mt19937 random(1);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> inner(0, 9.9), outer(10.1, 14);
  std::vector<CrossedSegment> segments;
  for (int i = 0; i < 500; ++i) {
    Eigen::Vector3d from = inner(random) * Eigen::Vector3d(gauss(random), gauss(random), gauss(random)).normalized();
    Eigen::Vector3d to = outer(random) * Eigen::Vector3d(gauss(random), gauss(random), gauss(random)).normalized();
    if (i % 2 == 0) std::swap(from, to);
    segments.push_back(segment(sphere, from, to));
  }
  const double tolerance = 1e-6;
  const auto roots = roots_on_segments(field_of(sphere), segments, tolerance);
  ASSERT_EQ(roots.size(), segments.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Eigen::Vector3d along = segments[i].to_mm - segments[i].from_mm;
    EXPECT_NEAR(roots[i].norm(), 10, tolerance * along.norm());
    EXPECT_LT((roots[i] - segments[i].from_mm).cross(along).norm(), 1e-9 * along.squaredNorm()) << "on its segment";
  }
}

TEST(RootsOnSegments, OfALinearFieldAreExactAfterOneLook) {
  int batches = 0;
  ScalarField field;
  field.values = [&](const Eigen::Matrix3Xd& points) -> Eigen::VectorXd {
    ++batches;
    return (points.row(0).array() - 0.3).matrix().transpose();
  };
  const auto roots =
      roots_on_segments(field, {{{0, 1, 2}, {1, 1, 2}, -0.3, 0.7}, {{2, 5, 5}, {0, 5, 5}, 1.7, -0.3}}, 1e-4);
  EXPECT_LT((roots[0] - Eigen::Vector3d(0.3, 1, 2)).norm(), 1e-12);
  EXPECT_LT((roots[1] - Eigen::Vector3d(0.3, 5, 5)).norm(), 1e-12);
  EXPECT_EQ(batches, 1);
}

TEST(RootsOnSegments, FindsTheRootOfCurvedFields) {
  const double tolerance = 1e-5;
  for (const double root : {0.03, 0.2, 0.6, 0.97}) {
    const auto cubic = [root](const Eigen::Vector3d& p) { return p.x() * p.x() * p.x() - root * root * root; };
    const auto exponential = [root](const Eigen::Vector3d& p) { return std::exp(8 * root) - std::exp(8 * p.x()); };
    for (const auto& f : {std::function<double(const Eigen::Vector3d&)>(cubic), {exponential}}) {
      const auto found = roots_on_segments(field_of(f), {segment(f, {0, 0, 0}, {1, 0, 0})}, tolerance);
      EXPECT_NEAR(found[0].x(), root, 2 * tolerance) << "root " << root;
    }
  }
}

TEST(RootsOnSegments, KeepTheToleranceFromTheEnds) {
  const auto plane = [](const Eigen::Vector3d& p) { return -p.x(); };  // zero, so inside, at the start
  const double tolerance = 1e-3;
  const auto roots = roots_on_segments(
      field_of(plane), {segment(plane, {0, 0, 0}, {2, 0, 0}), segment(plane, {2, 0, 0}, {0, 0, 0})}, tolerance);
  EXPECT_NEAR(roots[0].x(), 2 * tolerance, 1e-12);
  EXPECT_NEAR(roots[1].x(), 2 * tolerance, 1e-12);
}

TEST(RootsOnSegments, OfNoSegmentsAreNone) {
  EXPECT_TRUE(roots_on_segments(field_of([](const Eigen::Vector3d&) { return 1.0; }), {}, 1e-3).empty());
}

}  // namespace
}  // namespace isostack
