#include "recon/functions/r_functions.h"

#include <utility>

namespace isostack {

Eigen::ArrayXd r_union(const Eigen::ArrayXd& f1, const Eigen::ArrayXd& f2) {
  return f1 + f2 + (f1.square() + f2.square()).sqrt();
}

Eigen::ArrayXd r_intersection(const Eigen::ArrayXd& f1, const Eigen::ArrayXd& f2) {
  return f1 + f2 - (f1.square() + f2.square()).sqrt();
}

Eigen::ArrayXd r_subtraction(const Eigen::ArrayXd& f1, const Eigen::ArrayXd& f2) { return r_intersection(f1, -f2); }

SolidFunction r_union(SolidFunction f1, SolidFunction f2) {
  return [f1 = std::move(f1), f2 = std::move(f2)](const Eigen::MatrixXd& points) {
    return r_union(f1(points), f2(points));
  };
}

SolidFunction r_intersection(SolidFunction f1, SolidFunction f2) {
  return [f1 = std::move(f1), f2 = std::move(f2)](const Eigen::MatrixXd& points) {
    return r_intersection(f1(points), f2(points));
  };
}

SolidFunction r_subtraction(SolidFunction f1, SolidFunction f2) {
  return [f1 = std::move(f1), f2 = std::move(f2)](const Eigen::MatrixXd& points) {
    return r_subtraction(f1(points), f2(points));
  };
}

}  // namespace isostack
