#include "recon/solvers/cholesky.h"

#include <algorithm>

#include "recon/solvers/lapack.h"

namespace isostack {

namespace {

/// Wide enough for the products to run at full speed, narrow enough to stop within a second at 20,000 columns.
constexpr Eigen::Index panel_columns = 128;

}  // namespace

bool cholesky_in_place(Eigen::Ref<Eigen::MatrixXd> matrix, const Progress& progress) {
  const Eigen::Index count = matrix.cols();
  const int stride = static_cast<int>(matrix.outerStride());
  const double one = 1, minus_one = -1;
  for (Eigen::Index start = 0; start < count; start += panel_columns) {
    const int columns = static_cast<int>(std::min(panel_columns, count - start));
    const Eigen::Index below = start + columns;
    const int rest = static_cast<int>(count - below);
    int info = 0;
    dpotrf_("L", &columns, &matrix(start, start), &stride, &info);
    if (info != 0) return false;
    if (rest > 0) {
      dtrsm_("R", "L", "T", "N", &rest, &columns, &one, &matrix(start, start), &stride, &matrix(below, start), &stride);
      dsyrk_("L", "N", &rest, &columns, &minus_one, &matrix(below, start), &stride, &one, &matrix(below, below),
             &stride);
    }
    const double left = static_cast<double>(rest) / static_cast<double>(count);
    progress.report("solve", 1 - 0.9 * left * left * left);
  }
  return true;
}

}  // namespace isostack
