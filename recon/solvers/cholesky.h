#pragma once

#include <Eigen/Core>

#include "recon/geometry/progress.h"

namespace isostack {

/// Replaces the lower triangle of a symmetric positive definite matrix by its Cholesky factor, by LAPACK panel for
/// panel, so that it reports "solve" from 0.1 to 1 as the work goes on and stops when asked to. What is above the
/// diagonal is not touched. False when the matrix is not positive definite; its content is then of no use.
bool cholesky_in_place(Eigen::Ref<Eigen::MatrixXd> matrix, const Progress& progress = {});

}  // namespace isostack
