#include "recon/surface/surface_seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

struct Ball {
  Eigen::Vector3d centre_mm;
  double radius_mm;
};

/// The distance to the nearest of some spheres, positive in the balls, or in what they leave.
ScalarField balls(std::vector<Ball> all, double sign) {
  ScalarField field;
  field.values = [all = std::move(all), sign](const Eigen::Matrix3Xd& points) {
    Eigen::VectorXd values(points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      double inside = -1e9;
      for (const Ball& ball : all) inside = std::max(inside, ball.radius_mm - (points.col(i) - ball.centre_mm).norm());
      values[i] = sign * inside;
    }
    return values;
  };
  return field;
}

const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(60, 50, 40));

std::size_t near(const std::vector<Eigen::Vector3d>& seeds, const Ball& ball, double within_mm) {
  return static_cast<std::size_t>(std::count_if(seeds.begin(), seeds.end(), [&](const Eigen::Vector3d& seed) {
    return std::abs((seed - ball.centre_mm).norm() - ball.radius_mm) <= within_mm;
  }));
}

TEST(SurfaceSeeds, EveryBodyIsFoundAndEverySeedIsNearOne) {
  const Ball large{{20, 20, 20}, 12}, small{{48, 30, 12}, 3};
  const auto seeds = surface_seeds(balls({large, small}, 1), box, 2);
  EXPECT_GT(near(seeds, large, 1), 400U);
  EXPECT_GT(near(seeds, small, 1), 20U);
  EXPECT_EQ(near(seeds, large, 1) + near(seeds, small, 1), seeds.size());
}

// Radius 1 between nodes 2.5 mm apart: farther than 2 mm from each, so no node is inside.
TEST(SurfaceSeeds, BodiesAndHollowsBetweenTheNodesAreFound) {
  const Ball tiny{{31.3, 26.2, 21.2}, 1};
  for (const double sign : {1.0, -1.0}) {
    const auto seeds = surface_seeds(balls({tiny}, sign), box, 2.5);
    EXPECT_GE(seeds.size(), 1U);
    EXPECT_EQ(near(seeds, tiny, 1.25), seeds.size());
  }
}

TEST(SurfaceSeeds, AFieldOfOneSignHasNone) {
  EXPECT_TRUE(surface_seeds(balls({{{200, 0, 0}, 10}}, 1), box, 2).empty());
  EXPECT_TRUE(surface_seeds(balls({{{30, 25, 20}, 100}}, 1), box, 2).empty());
}

TEST(SurfaceSeeds, TooFineALatticeIsRefused) {
  EXPECT_THROW(surface_seeds(balls({{{30, 25, 20}, 10}}, 1), box, 1e-3), GeometryError);
}

}  // namespace
}  // namespace isostack
