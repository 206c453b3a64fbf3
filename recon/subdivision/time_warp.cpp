#include "recon/subdivision/time_warp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/geometry/errors.h"
#include "recon/subdivision/cardinal_spline.h"

namespace isostack {

namespace {

Eigen::Vector4d bernstein(double x) {
  const double y = 1 - x;
  return {y * y * y, 3 * x * y * y, 3 * x * x * y, x * x * x};
}

}  // namespace

double TimeWarp::shown_at(const Eigen::VectorXd& place, const Eigen::AlignedBox3d& box, double t) const {
  if (!is_set()) return t;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(1);
  for (Eigen::Index axis = 0; axis < place.size(); ++axis) {
    const double width = box.sizes()[axis];
    const double x = width > 0 ? std::clamp((place[axis] - box.min()[axis]) / width, 0.0, 1.0) : 0.5;
    const Eigen::MatrixXd product = weights * bernstein(x).transpose();
    weights = product.reshaped();
  }
  // The spline is linear in its points, so that the sum over the control points is taken first.
  const Eigen::Vector2d inner = controls * weights;
  return cardinal_spline(Eigen::RowVector4d(0, 1.0 / 3, 2.0 / 3, 1), Eigen::RowVector4d(0, inner[0], inner[1], 1),
                         t)[0];
}

TimeWarp sweep(const Eigen::VectorXd& direction, double lag) {
  const auto dimension = static_cast<int>(direction.size());
  const Eigen::Index count = dimension == 2 ? 16 : 64;
  TimeWarp warp;
  warp.controls.resize(2, count);
  const Eigen::VectorXd unit = direction.normalized();
  for (Eigen::Index c = 0; c < count; ++c) {
    double along = 0;  // 0 at the corner that comes first, 1 at the opposite one
    Eigen::Index rest = c;
    for (int axis = 0; axis < dimension; ++axis, rest /= 4) {
      const double x = static_cast<double>(rest % 4) / 3;
      along += unit[axis] > 0 ? unit[axis] * x : -unit[axis] * (1 - x);
    }
    along /= unit.lpNorm<1>();
    // From the straight line towards a late or an early change.
    const double bend = lag * (2 * along - 1);
    for (int i = 0; i < 2; ++i) {
      const double t = (i + 1) / 3.0;
      warp.controls(i, c) = t + bend * (bend > 0 ? 1 - t : t) * 0.6;
    }
  }
  return warp;
}

void require_warp(const TimeWarp& warp, int dimension) {
  if (!warp.is_set()) return;
  const Eigen::Index wanted = dimension == 2 ? 16 : 64;
  if (warp.controls.cols() != wanted)
    throw InputError("warp", fmt::format("{} control points", warp.controls.cols()),
                     fmt::format("give {}, 4 along each axis", wanted));
  const bool ascends = warp.controls.allFinite() && warp.controls.minCoeff() > 0 && warp.controls.maxCoeff() < 1 &&
                       (warp.controls.row(1) - warp.controls.row(0)).minCoeff() > 0;
  if (!ascends) throw InputError("warp", "a control point's times do not ascend from 0 to 1", "let them ascend");
}

}  // namespace isostack
