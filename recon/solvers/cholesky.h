#pragma once

#include <Eigen/Core>

#include "recon/geometry/progress.h"

namespace isostack {

/// Replaces the lower triangle of a symmetric positive definite matrix by its Cholesky factor: panel for panel by
/// LAPACK, in tiles by oneTBB, so that it reports "solve" from 0.1 to 1 as the work goes on, stops when asked to, and
/// rounds the same whatever the number of threads (under OneBlasThread). What is above the diagonal is not touched.
/// False when the matrix is not positive definite; its content is then of no use.
bool cholesky_in_place(Eigen::Ref<Eigen::MatrixXd> matrix, const Progress& progress = {});

}  // namespace isostack
