#include "recon/solvers/cholesky.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "recon/solvers/lapack.h"

namespace isostack {

namespace {

using Index = Eigen::Index;
using Matrix = Eigen::Ref<Eigen::MatrixXd>;

/// Wide enough for the products to run at full speed, narrow enough to stop within a second at 20,000 columns.
constexpr Index panel_columns = 128;
constexpr Index tile_rows = 256;
const double one = 1, minus_one = -1;

/// Rows of one tile of those from `below` on.
struct Tile {
  Tile(Index below, Index number, Index count)
      : first(below + number * tile_rows), rows(static_cast<int>(std::min(tile_rows, count - first))) {}
  Index first;
  int rows;
};

/// The panel's rows below its diagonal block: times the inverse of the block's factor.
void solve_panel(Matrix matrix, Index start, int columns, Index tiles) {
  const int stride = static_cast<int>(matrix.outerStride());
  tbb::parallel_for(Index{0}, tiles, [&](Index number) {
    const Tile tile(start + columns, number, matrix.cols());
    dtrsm_("R", "L", "T", "N", &tile.rows, &columns, &one, &matrix(start, start), &stride, &matrix(tile.first, start),
           &stride);
  });
}

/// What is right of the panel, on and below the diagonal: minus the panel times its transpose.
void subtract_panel(Matrix matrix, Index start, int columns, Index tiles) {
  const int stride = static_cast<int>(matrix.outerStride());
  tbb::parallel_for(Index{0}, tiles * tiles, [&](Index pair) {
    const Tile down(start + columns, pair / tiles, matrix.cols()), across(start + columns, pair % tiles, matrix.cols());
    double* target = &matrix(down.first, across.first);
    if (down.first == across.first)
      dsyrk_("L", "N", &down.rows, &columns, &minus_one, &matrix(down.first, start), &stride, &one, target, &stride);
    else if (down.first > across.first)
      dgemm_("N", "T", &down.rows, &across.rows, &columns, &minus_one, &matrix(down.first, start), &stride,
             &matrix(across.first, start), &stride, &one, target, &stride);
  });
}

}  // namespace

bool cholesky_in_place(Eigen::Ref<Eigen::MatrixXd> matrix, const Progress& progress) {
  const Index count = matrix.cols();
  const int stride = static_cast<int>(matrix.outerStride());
  for (Index start = 0; start < count; start += panel_columns) {
    const int columns = static_cast<int>(std::min(panel_columns, count - start));
    int info = 0;
    dpotrf_("L", &columns, &matrix(start, start), &stride, &info);
    if (info != 0) return false;
    const Index rest = count - start - columns, tiles = (rest + tile_rows - 1) / tile_rows;
    solve_panel(matrix, start, columns, tiles);
    subtract_panel(matrix, start, columns, tiles);
    const double left = static_cast<double>(rest) / static_cast<double>(count);
    progress.report("solve", 1 - 0.9 * left * left * left);
  }
  return true;
}

}  // namespace isostack
