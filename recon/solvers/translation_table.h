#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "recon/solvers/interactions.h"
#include "recon/solvers/radial_function.h"
#include "recon/solvers/spectrum_blocks.h"

namespace isostack {

/// The kernel between the grids of two cells of one level, as spectra, for the offsets asked for.
class TranslationTable {
 public:
  TranslationTable() = default;
  /// `cell_width` in the points' units. Holds no offset yet.
  TranslationTable(const RadialFunction& function, const NodeGrid& grid, const GridDft& dft, double cell_width);

  /// Adds the offsets that are missing; `used[offset]` tells which ones occur.
  void add(const GridDft& dft, const std::vector<bool>& used);

  std::uint32_t slot(std::uint32_t offset) const { return slots_[offset]; }
  /// The slot whose spectrum is zero, also that of offsets not asked for.
  static constexpr std::uint32_t empty_slot() { return 0; }
  /// Block `b` of slot `s` starts at block(b) + s · block_doubles.
  const double* block(std::size_t b) const { return spectra_.get() + b * slot_limit * block_doubles; }
  std::size_t bytes() const { return block_count_ * count_ * block_doubles * sizeof(double); }

 private:
  static constexpr std::size_t slot_limit = Interactions::offset_count + 1;
  void add_group(const GridDft& dft, const std::uint32_t* offsets, std::size_t count, std::size_t first_slot);

  RadialFunction function_;
  double step_ = 0, cell_width_ = 0;
  std::vector<std::uint32_t> slots_;
  std::size_t count_ = 0, block_count_ = 0;
  std::unique_ptr<double[]> spectra_;  ///< room for all offsets; pages no slot has used cost nothing
};

}  // namespace isostack
