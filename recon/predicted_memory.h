#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/slice.h"
#include "recon/reconstruct.h"

namespace isostack {

/// What one organ's reconstruction takes, known before it starts. Bytes, constraints and cells are upper estimates.
struct OrganPrediction {
  std::string name;
  std::size_t contours = 0;              ///< on all slices
  std::size_t contour_points = 0;        ///< given
  std::size_t boundary_constraints = 0;  ///< of those, kept for the first solve
  std::size_t constraints = 0;           ///< of the first solve
  std::size_t most_constraints = 0;      ///< after what planes and sections may add
  double resolution_mm = 0;              ///< of the extraction, before any refinement
  std::size_t cells = 0;                 ///< of the extraction grid that the surface passes, at that resolution
  std::string solver;                    ///< "dense" or "fast"
  std::size_t solver_bytes = 0;          ///< of the first solve, which the memory limit is compared with
  std::size_t solve_bytes = 0;           ///< at most while solving and evaluating, after all additions
  std::size_t surface_bytes = 0;         ///< at most while the surface is extracted
  std::size_t kept_bytes = 0;            ///< when it is done
};

struct MemoryPrediction {
  std::vector<OrganPrediction> organs;
  /// The most the process will hold at any time: what it holds already, and the largest moment of what follows.
  std::size_t process_bytes = 0;
};

/// For reconstruct_all() in a process that holds `held_bytes`, contours included. Makes the constraints, but solves
/// nothing. The numbers come from the cells of the solvers' trees and from measured runs (docs/benchmarks.md). Throws
/// as reconstruct() does before its first solve: fewer than two slices with contours, or a solve beyond
/// options.memory_limit_bytes.
MemoryPrediction predict_memory(const std::vector<ContourStack>& stacks, const ReconstructOptions& options,
                                std::size_t held_bytes);

/// For reconstruct_turk_obrien().
MemoryPrediction predict_memory_turk_obrien(const SliceStack& images, double level, const ReconstructOptions& options,
                                            std::size_t held_bytes);

}  // namespace isostack
