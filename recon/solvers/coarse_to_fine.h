#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "recon/geometry/progress.h"

namespace isostack {

struct CoarseToFineOptions {
  double radius_ratio = 0.7071;   ///< spacing of one level over that of the next coarser one
  int neighbours = 40;            ///< k, nearest predecessors on the finest level
  double neighbour_growth = 0.4;  ///< k_l = k · (N/N_l)^growth on a level with N_l points
  int most_neighbours = 300;
};

/// A coarse-to-fine elimination order of points and, per point, its nearest predecessors: the
/// sparsity of an approximate inverse Cholesky factor (Schäfer, Katzfuss & Owhadi 2021, §4). A level is what
/// remains of the finer one when points closer than a growing radius are thinned out.
struct CoarseToFine {
  /// One level's points and their predecessors, themselves not included.
  struct Level {
    std::vector<std::uint32_t> points;
    std::vector<std::uint64_t> begin;         ///< predecessors of points[k]: predecessors[begin[k]] … [begin[k + 1])
    std::vector<std::uint32_t> predecessors;  ///< nearest first
  };
  std::vector<Level> levels;  ///< finest first
};

/// `points` is n × N, distinct and in an order along a space-filling curve; `first` are the points that
/// precede all others (they get no predecessors and stand in no level). The result depends on
/// nothing but the arguments.
CoarseToFine order_coarse_to_fine(const Eigen::MatrixXd& points, const std::vector<std::uint32_t>& first,
                                  const CoarseToFineOptions& options, const Progress& progress = {});

}  // namespace isostack
