#include "recon/solvers/spectrum_blocks.h"

#include <algorithm>

#include <hwy/cache_control.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "recon/solvers/spectrum_blocks.cpp"
#include <hwy/foreach_target.h>  // compiles the SIMD part once per instruction set

#include "recon/solvers/radial_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isostack {
namespace HWY_NAMESPACE {

struct ComplexSum {
  Vec re, im;

  HWY_INLINE void add(const double* table, Vec source_re, Vec source_im) {
    const Vec tr = hn::LoadU(Lanes(), table), ti = hn::LoadU(Lanes(), table + frequency_block);
    re = hn::NegMulAdd(ti, source_im, hn::MulAdd(tr, source_re, re));
    im = hn::MulAdd(ti, source_re, hn::MulAdd(tr, source_im, im));
  }
  HWY_INLINE void store(double* out) const {
    hn::StoreU(re, Lanes(), out);
    hn::StoreU(im, Lanes(), out + frequency_block);
  }
};

void sum_block_simd(const QuadTerm* terms, std::size_t count, const double* table, const double* sources, double* out) {
  constexpr std::size_t ahead = 8;  // the sources are scattered over memory
  const Lanes tag;
  for (std::size_t part = 0; part < frequency_block; part += hn::Lanes(tag)) {
    const ComplexSum zero{hn::Zero(tag), hn::Zero(tag)};
    ComplexSum a = zero, b = zero, c = zero, d = zero;
    for (std::size_t k = 0; k < count; ++k) {
      const QuadTerm& term = terms[k];
      if (k + ahead < count) {
        const double* later = sources + terms[k + ahead].source * block_doubles;
        hwy::Prefetch(later);
        hwy::Prefetch(later + frequency_block);
      }
      const double* source = sources + term.source * block_doubles + part;
      const Vec re = hn::LoadU(tag, source), im = hn::LoadU(tag, source + frequency_block);
      a.add(table + term.slots[0] * block_doubles + part, re, im);
      b.add(table + term.slots[1] * block_doubles + part, re, im);
      c.add(table + term.slots[2] * block_doubles + part, re, im);
      d.add(table + term.slots[3] * block_doubles + part, re, im);
    }
    a.store(out + part);
    b.store(out + block_doubles + part);
    c.store(out + 2 * block_doubles + part);
    d.store(out + 3 * block_doubles + part);
  }
}

/// Every eighth value of an array, as one vector.
HWY_INLINE Vec gather_lane(const double* from) {
  const hn::RebindToSigned<Lanes> index;
  return hn::GatherIndex(Lanes(), from, hn::Mul(hn::Iota(index, 0), hn::Set(index, sibling_lanes)));
}

HWY_INLINE void scatter_lane(Vec v, double* to) {
  const hn::RebindToSigned<Lanes> index;
  hn::ScatterIndex(v, Lanes(), to, hn::Mul(hn::Iota(index, 0), hn::Set(index, sibling_lanes)));
}

void store_lane_simd(const double* real, const double* imaginary, std::size_t frequencies, double* cell,
                     std::size_t stride) {
  const Lanes tag;
  for (std::size_t begin = 0; begin < frequencies; begin += frequency_block, cell += stride) {
    const std::size_t count = std::min(frequency_block, frequencies - begin);
    if (count == frequency_block) {
      for (std::size_t k = 0; k < frequency_block; k += hn::Lanes(tag)) {
        hn::StoreU(gather_lane(real + (begin + k) * sibling_lanes), tag, cell + k);
        hn::StoreU(gather_lane(imaginary + (begin + k) * sibling_lanes), tag, cell + frequency_block + k);
      }
      continue;
    }
    std::fill_n(cell, block_doubles, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      cell[k] = real[(begin + k) * sibling_lanes];
      cell[frequency_block + k] = imaginary[(begin + k) * sibling_lanes];
    }
  }
}

void load_lane_simd(const double* cell, std::size_t stride, std::size_t frequencies, double* real, double* imaginary) {
  const Lanes tag;
  for (std::size_t begin = 0; begin < frequencies; begin += frequency_block, cell += stride) {
    const std::size_t count = std::min(frequency_block, frequencies - begin);
    if (count == frequency_block) {
      for (std::size_t k = 0; k < frequency_block; k += hn::Lanes(tag)) {
        scatter_lane(hn::LoadU(tag, cell + k), real + (begin + k) * sibling_lanes);
        scatter_lane(hn::LoadU(tag, cell + frequency_block + k), imaginary + (begin + k) * sibling_lanes);
      }
      continue;
    }
    for (std::size_t k = 0; k < count; ++k) {
      real[(begin + k) * sibling_lanes] = cell[k];
      imaginary[(begin + k) * sibling_lanes] = cell[frequency_block + k];
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isostack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isostack {

HWY_EXPORT(sum_block_simd);
HWY_EXPORT(store_lane_simd);
HWY_EXPORT(load_lane_simd);

void sum_spectrum_block(const QuadTerm* terms, std::size_t count, const double* table, const double* sources,
                        double* out) {
  HWY_DYNAMIC_DISPATCH(sum_block_simd)(terms, count, table, sources, out);
}

void store_lane(const double* real, const double* imaginary, std::size_t frequencies, std::size_t lane, double* cell,
                std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(store_lane_simd)(real + lane, imaginary + lane, frequencies, cell, stride);
}

void load_lane(const double* cell, std::size_t stride, std::size_t frequencies, std::size_t lane, double* real,
               double* imaginary) {
  HWY_DYNAMIC_DISPATCH(load_lane_simd)(cell, stride, frequencies, real + lane, imaginary + lane);
}

}  // namespace isostack
#endif
