#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "recon/solvers/interactions.h"
#include "recon/solvers/node_grid.h"
#include "recon/solvers/radial_function.h"

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

/// Spectra are stored in blocks of this many frequencies, real parts before imaginary ones: one
/// block of all translations stays in the first-level cache.
constexpr std::size_t frequency_block = 8;
constexpr std::size_t block_doubles = 2 * frequency_block;

inline std::size_t block_count(const GridDft& dft) {
  return (dft.frequency_count() + frequency_block - 1) / frequency_block;
}

/// The kernel between the grids of two cells of one level, as spectra, for every offset that occurs.
class TranslationTable {
 public:
  TranslationTable() = default;
  /// `used[offset]` tells which offsets occur. `cell_width` in the points' units.
  TranslationTable(const RadialFunction& function, const NodeGrid& grid, const GridDft& dft, double cell_width,
                   const std::vector<bool>& used);

  std::uint32_t slot(std::uint32_t offset) const { return slots_[offset]; }
  /// The slot whose spectrum is zero.
  std::uint32_t empty_slot() const { return static_cast<std::uint32_t>(count_); }
  /// Block `b` of slot `s` starts at block(b) + s · block_doubles.
  const double* block(std::size_t b) const { return spectra_.data() + b * (count_ + 1) * block_doubles; }
  std::size_t bytes() const { return spectra_.size() * sizeof(double); }

 private:
  std::vector<std::uint32_t> slots_;
  std::size_t count_ = 0;
  std::vector<double> spectra_;
};

/// Siblings whose sums are formed together, so that they share the loads of the sources.
constexpr std::size_t quad = 4;

/// One source cell and where it lies as seen from each of four target cells.
struct QuadTerm {
  std::uint32_t source;
  std::array<std::uint32_t, quad> slots;  ///< in the translation table; empty_slot() where it is not far
};

/// out[t] = Σ table[slots[t]] · sources[source] for one block of frequencies of four target cells.
void sum_spectrum_block(const QuadTerm* terms, std::size_t count, const double* table, const double* sources,
                        double* out);

/// Between eight lanes of spectra and the block layout of one cell: block b at cell + b · stride.
void store_lane(const double* real, const double* imaginary, std::size_t frequencies, std::size_t lane, double* cell,
                std::size_t stride);
void load_lane(const double* cell, std::size_t stride, std::size_t frequencies, std::size_t lane, double* real,
               double* imaginary);

}  // namespace isostack
