#include "recon/subdivision/cardinal_spline.h"

namespace isostack {

namespace {

Eigen::VectorXd slope(const Eigen::RowVectorXd& s, const Eigen::MatrixXd& points, Eigen::Index i) {
  return (points.col(i + 1) - points.col(i)) / (s[i + 1] - s[i]);
}

Eigen::VectorXd tangent(const Eigen::RowVectorXd& s, const Eigen::MatrixXd& points, Eigen::Index i) {
  const Eigen::Index last = points.cols() - 1;
  if (last == 1) return slope(s, points, 0);
  const auto inner = [&](Eigen::Index k) -> Eigen::VectorXd {
    const double before = s[k] - s[k - 1], after = s[k + 1] - s[k];
    return (after * slope(s, points, k - 1) + before * slope(s, points, k)) / (before + after);
  };
  if (i == 0) return 2 * slope(s, points, 0) - inner(1);
  if (i == last) return 2 * slope(s, points, last - 1) - inner(last - 1);
  return inner(i);
}

}  // namespace

Eigen::VectorXd cardinal_spline(const Eigen::RowVectorXd& parameters, const Eigen::MatrixXd& points, double at) {
  const Eigen::Index last = points.cols() - 1;
  if (last == 0) return points.col(0);
  if (at < parameters[0]) return points.col(0) + (at - parameters[0]) * tangent(parameters, points, 0);
  if (at > parameters[last]) return points.col(last) + (at - parameters[last]) * tangent(parameters, points, last);
  Eigen::Index i = 0;
  while (i + 1 < last && parameters[i + 1] <= at) ++i;
  const double length = parameters[i + 1] - parameters[i], s = (at - parameters[i]) / length;
  return (1 + 2 * s) * (1 - s) * (1 - s) * points.col(i) +
         length * s * (1 - s) * (1 - s) * tangent(parameters, points, i) + s * s * (3 - 2 * s) * points.col(i + 1) +
         length * s * s * (s - 1) * tangent(parameters, points, i + 1);
}

}  // namespace isostack
