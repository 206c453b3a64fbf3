#include "recon/functions/bounded_blend.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "recon/functions/r_functions.h"
#include "recon/geometry/errors.h"

namespace isostack {

void require_usable(const BlendParameters& p) {
  const auto is_positive = [](double a) { return std::isfinite(a) && a > 0; };
  if (!(std::isfinite(p.a0) && p.a0 >= 0) || !is_positive(p.a1) || !is_positive(p.a2) || !is_positive(p.a3))
    throw InputError("blend", fmt::format("parameters a0 {:g}, a1 {:g}, a2 {:g}, a3 {:g}", p.a0, p.a1, p.a2, p.a3),
                     "give a0 of 0 or more, and a1, a2, a3 above 0");
}

Eigen::ArrayXd blend_displacement(const Eigen::ArrayXd& f1, const Eigen::ArrayXd& f2, const Eigen::ArrayXd& f3,
                                  const BlendParameters& p) {
  const Eigen::ArrayXd near = (f1 / p.a1).square() + (f2 / p.a2).square();
  const Eigen::ArrayXd within = (f3.max(0) / p.a3).square();
  const Eigen::ArrayXd r = (within > 0).select(near / (near + within), 1);  // squared
  return (1 - r).cube() / (1 + r);
}

SolidFunction bounded_blend_union(SolidFunction f1, SolidFunction f2, SolidFunction bounds,
                                  const BlendParameters& parameters) {
  require_usable(parameters);
  return [f1 = std::move(f1), f2 = std::move(f2), f3 = std::move(bounds),
          p = parameters](const Eigen::MatrixXd& points) -> Eigen::ArrayXd {
    const Eigen::ArrayXd first = f1(points), second = f2(points);
    return r_union(first, second) + p.a0 * blend_displacement(first, second, f3(points), p);
  };
}

SolidFunction bounded_blend_subtraction(SolidFunction f1, SolidFunction f2, SolidFunction bounds,
                                        const BlendParameters& parameters) {
  require_usable(parameters);
  return [f1 = std::move(f1), f2 = std::move(f2), f3 = std::move(bounds),
          p = parameters](const Eigen::MatrixXd& points) -> Eigen::ArrayXd {
    const Eigen::ArrayXd first = f1(points), second = f2(points);
    return r_subtraction(first, second) - p.a0 * blend_displacement(first, second, f3(points), p);
  };
}

}  // namespace isostack
