#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "recon/solvers/grid_dft.h"

namespace isostack {

/// Spectra are stored in blocks of this many frequencies, real parts before imaginary ones: one
/// block of all translations stays in the first-level cache.
constexpr std::size_t frequency_block = 8;
constexpr std::size_t block_doubles = 2 * frequency_block;

inline std::size_t block_count(const GridDft& dft) {
  return (dft.frequency_count() + frequency_block - 1) / frequency_block;
}

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
