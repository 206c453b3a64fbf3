#pragma once

#include <cstddef>

#include "recon/solvers/radial_function.h"

namespace isostack {

/// Points as one array per axis.
struct PointArrays {
  const double* x = nullptr;
  const double* y = nullptr;
  const double* z = nullptr;
  std::size_t count = 0;
};

/// Where sums are added to, per target. Null pointers are not wanted: either the value alone,
/// or value and gradient, or all. The Hessian's order is xx, yy, zz, yz, xz, xy.
struct SumArrays {
  double* value = nullptr;
  double* gradient[3] = {nullptr, nullptr, nullptr};
  double* hessian[6] = {nullptr, nullptr, nullptr, nullptr, nullptr, nullptr};

  SumArrays from(std::size_t first) const;
};

/// Every source array is padded to a multiple of this with zero weights.
constexpr std::size_t source_padding = 8;

/// Adds Σ_j weights_j φ(|t_i − s_j|) over all sources to every target, term by term, by SIMD chosen
/// at run time. `sources.count` is a multiple of `source_padding`.
void add_near_sums(const RadialFunction& function, const PointArrays& sources, const double* weights,
                   const PointArrays& targets, const SumArrays& sums);

}  // namespace isostack
