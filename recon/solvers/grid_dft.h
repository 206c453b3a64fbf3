#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "recon/solvers/node_grid.h"

namespace isostack {

/// Discrete Fourier transforms of node grids, padded to 2p − 1 along each axis so that products of
/// spectra are the aperiodic convolutions that carry a source cell's nodes to a target cell's.
/// Eight grids are transformed at once, one per SIMD lane. The sizes are so small that plain
/// sums over tabulated sines and cosines beat a fast transform.
class GridDft {
 public:
  GridDft() = default;
  explicit GridDft(const NodeGrid& grid);

  int padded(int axis) const { return padded_[static_cast<std::size_t>(axis)]; }
  /// Complex values that describe a real grid's spectrum.
  std::size_t frequency_count() const { return static_cast<std::size_t>(padded_[0] * padded_[1] * half_); }

  /// Real input [x][y][z][lane] of `inputs` values per axis (at most padded) to spectra [frequency][lane].
  void forward(const std::array<int, 3>& inputs, const double* in, double* real, double* imaginary,
               std::vector<double>& scratch) const;
  /// Spectra to the first `outputs` values per axis; without the factor 1/∏padded. Destroys the spectra.
  void inverse(const std::array<int, 3>& outputs, double* real, double* imaginary, double* out,
               std::vector<double>& scratch) const;

  struct Axis {
    int size = 1;
    std::vector<double> cosines, sines;  ///< of 2πkj/size at [k · size + j]
    explicit Axis(int n = 1);
  };

 private:
  std::array<int, 3> padded_{1, 1, 1};
  int half_ = 1;
  std::array<Axis, 3> axes_;
};

}  // namespace isostack
