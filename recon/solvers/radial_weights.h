#pragma once

#include <Eigen/Core>

#include "recon/kernels/polynomial.h"

namespace isostack {

/// The solution of one interpolation problem: f(x) = Σ_j weights_j φ(|x − c_j|) + tail(x).
struct RadialWeights {
  Eigen::VectorXd weights;
  PolynomialBasis tail;
  Eigen::VectorXd tail_coefficients;
};

}  // namespace isostack
