#include "recon/subdivision/time_warp.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"
#include "recon/subdivision/cardinal_spline.h"

namespace isostack {
namespace {

const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(10, 20, 40));

TEST(CardinalSpline, PassesThroughItsPointsAndReproducesAParabola) {
  const Eigen::RowVector4d at(0, 1, 3, 4);
  const Eigen::MatrixXd points = at.array().square().matrix();
  for (const double t : {0.0, 0.3, 1.0, 2.2, 3.0, 3.7, 4.0})
    EXPECT_NEAR(cardinal_spline(at, points, t)[0], t * t, 1e-12);  // rounding
}

TEST(TimeWarp, OfTheSameTimesEverywhereIsThatTime) {
  TimeWarp warp;
  warp.controls.resize(2, 16);
  warp.controls.row(0).setConstant(1.0 / 3);
  warp.controls.row(1).setConstant(2.0 / 3);
  for (const double t : {0.0, 0.2, 0.5, 1.0})
    EXPECT_NEAR(warp.shown_at(Eigen::Vector2d(3, 11), box, t), t, 1e-12);  // rounding
}

TEST(TimeWarp, SweepsFromOneSideToTheOtherAndKeepsTheEnds) {
  for (const Eigen::VectorXd& direction :
       {Eigen::VectorXd(Eigen::Vector2d(0, 1)), Eigen::VectorXd(Eigen::Vector3d(0, 1, 0))}) {
    const TimeWarp warp = sweep(direction, 0.8);
    require_warp(warp, static_cast<int>(direction.size()));
    Eigen::VectorXd place = Eigen::VectorXd::Constant(direction.size(), 5);
    double before = 0;
    for (const double y : {0.0, 5.0, 10.0, 15.0, 20.0}) {
      place[1] = y;
      EXPECT_EQ(warp.shown_at(place, box, 0), 0);
      EXPECT_EQ(warp.shown_at(place, box, 1), 1);
      const double half = warp.shown_at(place, box, 0.5);
      EXPECT_GT(half, before);
      before = half;
      for (double t = 0; t < 0.99; t += 0.01)
        EXPECT_LT(warp.shown_at(place, box, t), warp.shown_at(place, box, t + 0.01)) << y << " " << t;
    }
  }
}

TEST(TimeWarp, RefusesTimesThatDoNotAscend) {
  TimeWarp warp = sweep(Eigen::Vector2d(1, 0), 0.5);
  EXPECT_THROW(require_warp(warp, 3), InputError);
  warp.controls(0, 5) = 0.9;
  EXPECT_THROW(require_warp(warp, 2), InputError);
}

}  // namespace
}  // namespace isostack
