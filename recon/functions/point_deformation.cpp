#include "recon/functions/point_deformation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

// 1 / the largest slope of w, at ρ = 1/√3: with a shorter radius two points come from the same place.
const double least_radius = 8 / (3 * std::sqrt(3.0));

void require_usable(const PointDeformation& d) {
  if (d.from_mm.size() == 0 || d.from_mm.size() != d.to_mm.size())
    throw InputError("deformation", "its points have different numbers of coordinates", "give both points alike");
  if (!(d.during_mm.from < d.during_mm.to))
    throw InputError("deformation", "it ends before it begins", "give a later end");
  const double way_mm = (d.to_mm - d.from_mm).norm();
  if (!(d.radius_mm > 0 && d.radius_mm >= least_radius * way_mm))
    throw InputError(
        "deformation",
        fmt::format("a point moved by {:.4g} mm with its surroundings of {:.4g} mm folds space", way_mm, d.radius_mm),
        fmt::format("give a radius of {:.4g} mm or more", least_radius * way_mm));
}

double smooth_step(double t) {
  const double s = std::clamp(t, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

}  // namespace

SolidFunction deformed(SolidFunction space_time_solid, const PointDeformation& deformation) {
  require_usable(deformation);
  return [f = std::move(space_time_solid), d = deformation](const Eigen::MatrixXd& points) {
    Eigen::MatrixXd source = points;
    const Eigen::Index k = points.rows() - 1;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const double progress = (points(k, i) - d.during_mm.from) / (d.during_mm.to - d.during_mm.from);
      const Eigen::VectorXd moved = smooth_step(progress) * (d.to_mm - d.from_mm);
      const double rho = (points.col(i).head(k) - d.from_mm - moved).norm() / d.radius_mm;
      if (rho < 1) source.col(i).head(k) -= std::pow(1 - rho * rho, 2) * moved;
    }
    return f(source);
  };
}

}  // namespace isostack
