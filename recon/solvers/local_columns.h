#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "recon/kernels/kernel.h"

namespace isostack {

/// Up to eight local systems of equal size, one per SIMD lane. Row 0 is the point whose column is
/// wanted, the others are its predecessors; rows with presence 0 only fill up.
/// Element (row, …, lane) stands at [… · local_lanes + lane].
struct LocalSystems {
  static constexpr std::size_t local_lanes = 8;

  std::size_t rows = 0;  ///< a multiple of 4 beyond the number of monomials; see padded_rows
  int dimension = 0;
  std::vector<double> coordinates;  ///< [row][axis][lane], relative to row 0 and scaled to about 1
  std::vector<double> presence;     ///< [row][lane], 1 or 0
  std::vector<double> smoothing;    ///< [row][lane], in the scaled system's units
  std::vector<double> columns;      ///< result [row][lane]; 0 in lanes that failed
  bool solved[local_lanes] = {};

  static std::size_t padded_rows(std::size_t rows, std::size_t monomials) {
    return monomials + (rows - monomials + 3) / 4 * 4;
  }
  void resize(std::size_t row_count, int point_dimension);

  std::vector<double> work;
};

/// For every lane u = Z (Zᵀ A Z)⁻¹ Zᵀ e₀, scaled to u₀ = uᵀAu: one column of the sparse inverse Cholesky
/// factor that is optimal in Kullback–Leibler's sense (Schäfer, Katzfuss & Owhadi 2021, Theorem 2.1). A is
/// sign · φ plus smoothing; the columns of Z span the vectors that annihilate the monomials
/// (`exponents`, axes × count), so every column does. A lane fails where its point cannot be
/// told from polynomials on its predecessors or where A is not definite in double precision.
void solve_local_systems(const Kernel& kernel, const Eigen::MatrixXi& exponents, LocalSystems& systems);

}  // namespace isostack
