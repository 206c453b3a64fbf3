#include "recon/solvers/translation_table.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "recon/solvers/translation_table.cpp"
#include <hwy/foreach_target.h>  // compiles the SIMD part once per instruction set

#include "recon/solvers/radial_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isostack {
namespace HWY_NAMESPACE {

/// Replaces squared distances by factor · φ; their count is a multiple of eight.
void kernel_lanes(const RadialFunction& function, double factor, double* values, std::size_t count) {
  const Lanes tag;
  with_kernel(function.kernel, [&](const auto& phi) HWY_ATTR {
    for (std::size_t k = 0; k < count; k += hn::Lanes(tag)) {
      const Vec squared = hn::Add(hn::LoadU(tag, values + k), set(function.shift_squared + tiny_squared));
      hn::StoreU(hn::Mul(set(factor), phi.value(squared)), tag, values + k);
    }
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace isostack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isostack {

HWY_EXPORT(kernel_lanes);

TranslationTable::TranslationTable(const RadialFunction& function, const NodeGrid& grid, const GridDft& dft,
                                   double cell_width)
    : function_(function),
      step_(grid.spacing() * cell_width / 2),
      cell_width_(cell_width),
      slots_(Interactions::offset_count, empty_slot()),
      count_(1),
      block_count_(isostack::block_count(dft)),
      spectra_(new double[block_count_ * slot_limit * block_doubles]) {
  for (std::size_t b = 0; b < block_count_; ++b)
    std::fill_n(spectra_.get() + b * slot_limit * block_doubles, block_doubles, 0.0);
}

void TranslationTable::add(const GridDft& dft, const std::vector<bool>& used) {
  std::vector<std::uint32_t> offsets;
  const std::size_t first_slot = count_;
  for (std::uint32_t offset = 0; offset < used.size(); ++offset)
    if (used[offset] && slots_[offset] == empty_slot()) {
      slots_[offset] = static_cast<std::uint32_t>(count_++);
      offsets.push_back(offset);
    }
  tbb::parallel_for(std::size_t{0}, (offsets.size() + sibling_lanes - 1) / sibling_lanes, [&](std::size_t group) {
    const std::size_t begin = group * sibling_lanes;
    add_group(dft, offsets.data() + begin, std::min(sibling_lanes, offsets.size() - begin), first_slot + begin);
  });
}

/// Up to eight offsets, one per lane.
void TranslationTable::add_group(const GridDft& dft, const std::uint32_t* offsets, std::size_t count,
                                 std::size_t first_slot) {
  const std::array<int, 3> n{dft.padded(0), dft.padded(1), dft.padded(2)};
  const std::size_t size = static_cast<std::size_t>(n[0] * n[1] * n[2]), frequencies = dft.frequency_count();
  std::vector<double> values(size * sibling_lanes), re(frequencies * sibling_lanes), im(re.size()), scratch;
  // Along each axis: squared distances [node][lane]. Node a stands for a difference of a nodes, or a − n
  // beyond the middle.
  std::array<std::vector<double>, 3> squares;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int a = 0; a < n[axis]; ++a)
      for (std::size_t lane = 0; lane < sibling_lanes; ++lane) {
        const auto offset = static_cast<int>(offsets[std::min(lane, count - 1)]);
        const int cells[3] = {offset / 49 - 3, offset / 7 % 7 - 3, offset % 7 - 3};
        const double d = step_ * (a > n[axis] / 2 ? a - n[axis] : a) - cells[axis] * cell_width_;
        squares[axis].push_back(d * d);
      }
  double* at = values.data();
  for (int a = 0; a < n[0]; ++a)
    for (int b = 0; b < n[1]; ++b)
      for (int c = 0; c < n[2]; ++c, at += sibling_lanes)
        for (std::size_t lane = 0; lane < sibling_lanes; ++lane) {
          const auto along = [&](std::size_t axis, int node) {
            return squares[axis][static_cast<std::size_t>(node) * sibling_lanes + lane];
          };
          at[lane] = along(0, a) + along(1, b) + along(2, c);
        }
  // The inverse transform's factor is applied here.
  HWY_DYNAMIC_DISPATCH(kernel_lanes)(function_, 1 / static_cast<double>(size), values.data(), values.size());
  dft.forward(n, values.data(), re.data(), im.data(), scratch);
  for (std::size_t lane = 0; lane < count; ++lane)
    store_lane(re.data(), im.data(), frequencies, lane, spectra_.get() + (first_slot + lane) * block_doubles,
               slot_limit * block_doubles);
}

}  // namespace isostack
#endif
