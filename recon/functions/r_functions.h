#pragma once

#include <Eigen/Core>

#include "recon/functions/solid_function.h"

namespace isostack {

// Set operations by R-functions (Rvachev 1974; Pasko et al. 1995, §4): their sign is exactly that of the union, the
// intersection or the difference, and they are smooth except where both arguments are 0.

/// f1 + f2 + √(f1² + f2²)
Eigen::ArrayXd r_union(const Eigen::ArrayXd& f1, const Eigen::ArrayXd& f2);
/// f1 + f2 − √(f1² + f2²)
Eigen::ArrayXd r_intersection(const Eigen::ArrayXd& f1, const Eigen::ArrayXd& f2);
/// f1 − f2 − √(f1² + f2²)
Eigen::ArrayXd r_subtraction(const Eigen::ArrayXd& f1, const Eigen::ArrayXd& f2);

SolidFunction r_union(SolidFunction f1, SolidFunction f2);
SolidFunction r_intersection(SolidFunction f1, SolidFunction f2);
SolidFunction r_subtraction(SolidFunction f1, SolidFunction f2);

}  // namespace isostack
