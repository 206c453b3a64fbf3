// Cholesky factors of many small matrices at once, one per SIMD lane. Included once per instruction set by the files
// that use Highway's foreach_target; not a header for anybody else.

#if defined(ISOSTACK_LANE_CHOLESKY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSTACK_LANE_CHOLESKY_INL_H_
#undef ISOSTACK_LANE_CHOLESKY_INL_H_
#else
#define ISOSTACK_LANE_CHOLESKY_INL_H_
#endif

#include <cstddef>

#include "recon/solvers/local_columns.h"
#include "recon/solvers/radial_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isostack {
namespace HWY_NAMESPACE {

constexpr std::size_t stride = LocalSystems::local_lanes;  ///< from an element of one lane to the next element
constexpr std::size_t tile = 4;

HWY_INLINE Vec load(const double* p) { return hn::LoadU(Lanes(), p); }
HWY_INLINE void store(Vec v, double* p) { hn::StoreU(v, Lanes(), p); }

/// One vector of lanes of symmetric matrices, their lower half in tiles of 4 × 4, and then of their factors.
class LaneCholesky {
 public:
  LaneCholesky() = default;
  /// `matrix` has stored_elements(size) elements; `size` is a multiple of 4.
  LaneCholesky(double* matrix, std::size_t size) : matrix_(matrix), size_(size) {}

  static std::size_t stored_elements(std::size_t size) {
    const std::size_t tiles = size / tile;
    return tiles * (tiles + 1) / 2 * tile * tile;
  }

  /// j ≤ i.
  HWY_INLINE double* element(std::size_t i, std::size_t j) const {
    return tile_at(i / tile, j / tile) + (i % tile * tile + j % tile) * stride;
  }

  /// A = L Lᵀ in place; the diagonal holds reciprocals. Returns 1 in the lanes where A is definite.
  HWY_NOINLINE Vec factor() const {
    Vec good = set(1.0);
    for (std::size_t j = 0; j < size_ / tile; ++j)
      for (std::size_t i = j; i < size_ / tile; ++i) {
        Vec sum[tile][tile];
        double* target = tile_at(i, j);
        for (std::size_t r = 0; r < tile; ++r)
          for (std::size_t c = 0; c < tile; ++c) sum[r][c] = load(target + (r * tile + c) * stride);
        subtract_columns_before(i, j, sum);
        if (i == j)
          good = factor_diagonal(sum, good);
        else
          divide_by_diagonal(tile_at(j, j), sum);
        for (std::size_t r = 0; r < tile; ++r)
          for (std::size_t c = 0; c < tile; ++c) store(sum[r][c], target + (r * tile + c) * stride);
      }
    return good;
  }

  /// (L Lᵀ)⁻¹ right; both are vectors of lanes, `stride` apart.
  HWY_INLINE void solve(const double* right, double* solution) const {
    for (std::size_t i = 0; i < size_; ++i) {
      Vec sum = load(right + i * stride);
      for (std::size_t j = 0; j < i; ++j) sum = hn::NegMulAdd(load(element(i, j)), load(solution + j * stride), sum);
      store(hn::Mul(sum, load(element(i, i))), solution + i * stride);
    }
    for (std::size_t i = size_; i-- > 0;) {
      const Vec x = hn::Mul(load(solution + i * stride), load(element(i, i)));
      store(x, solution + i * stride);
      for (std::size_t j = 0; j < i; ++j)
        store(hn::NegMulAdd(x, load(element(i, j)), load(solution + j * stride)), solution + j * stride);
    }
  }

 private:
  HWY_INLINE double* tile_at(std::size_t i, std::size_t j) const {
    return matrix_ + (i * (i + 1) / 2 + j) * tile * tile * stride;
  }

  /// What the factor's columns before tile (i, j) contribute to it.
  HWY_INLINE void subtract_columns_before(std::size_t i, std::size_t j, Vec (&sum)[tile][tile]) const {
    const double* left = tile_at(i, 0);
    const double* right = tile_at(j, 0);
    for (std::size_t k = 0; k < j; ++k, left += tile * tile * stride, right += tile * tile * stride)
      for (std::size_t q = 0; q < tile; ++q) {
        Vec b[tile];
        for (std::size_t c = 0; c < tile; ++c) b[c] = load(right + (c * tile + q) * stride);
        for (std::size_t r = 0; r < tile; ++r) {
          const Vec a = load(left + (r * tile + q) * stride);
          for (std::size_t c = 0; c < tile; ++c) sum[r][c] = hn::NegMulAdd(a, b[c], sum[r][c]);
        }
      }
  }

  HWY_INLINE static Vec factor_diagonal(Vec (&sum)[tile][tile], Vec good) {
    for (std::size_t c = 0; c < tile; ++c) {
      const auto positive = hn::Gt(sum[c][c], set(1e-15));
      good = hn::IfThenElseZero(positive, good);
      sum[c][c] = hn::Div(set(1.0), hn::Sqrt(hn::IfThenElse(positive, sum[c][c], set(1.0))));
      for (std::size_t r = c + 1; r < tile; ++r) {
        sum[r][c] = hn::Mul(sum[r][c], sum[c][c]);
        for (std::size_t d = c + 1; d <= r; ++d) sum[r][d] = hn::NegMulAdd(sum[r][c], sum[d][c], sum[r][d]);
      }
    }
    return good;
  }

  HWY_INLINE static void divide_by_diagonal(const double* diagonal, Vec (&sum)[tile][tile]) {
    for (std::size_t c = 0; c < tile; ++c) {
      const Vec inverse = load(diagonal + (c * tile + c) * stride);
      for (std::size_t r = 0; r < tile; ++r) {
        sum[r][c] = hn::Mul(sum[r][c], inverse);
        for (std::size_t d = c + 1; d < tile; ++d)
          sum[r][d] = hn::NegMulAdd(sum[r][c], load(diagonal + (d * tile + c) * stride), sum[r][d]);
      }
    }
  }

  double* matrix_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace isostack
HWY_AFTER_NAMESPACE();

#endif
