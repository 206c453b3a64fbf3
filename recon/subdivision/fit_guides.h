#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "recon/subdivision/multiresolution_fit.h"

namespace isostack {

/// Two base vertices of the interpolator, at different t, and where the way between them leads.
struct FeatureLine {
  std::array<int, 2> ends;
  Eigen::MatrixXd by_way_of = {};  ///< x, y(, z), t, mm: one column per place; straight when there is none
  bool sharp = false;              ///< smoothing leaves the line's vertices alone
};

/// The line becomes a constraint (Ohbuchi, Kokojima & Takahashi 2001, Section 2.4.1): a chain of edges that rise in t,
/// of the coarsest level that has one, follows a cardinal spline. Throws InputError when no level has such a chain, or
/// the places are not at times of their own between the ends'.
void add_line(FitProblem& problem, const FeatureLine& line);

/// The level's vertex nearest to a place (x, y(, z), t), first in t, sources' left out, is pulled to another: broadly
/// where the level is coarse (Section 2.4.3).
void add_pull(FitProblem& problem, int level, const Eigen::VectorXd& at, const Eigen::VectorXd& to_mm);

}  // namespace isostack
