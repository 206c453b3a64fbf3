#include "recon/solvers/local_columns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "recon/solvers/local_columns.cpp"
#include <hwy/foreach_target.h>  // compiles the SIMD part once per instruction set

#include "recon/solvers/lane_cholesky-inl.h"
#include "recon/solvers/radial_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isostack {
namespace HWY_NAMESPACE {

/// One vector of lanes of the batch, with the work arrays behind it. `M` is the number of monomials,
/// or 0 for a number known at run time only.
template <int M, class Phi>
class Solver {
 public:
  Solver(const Phi& phi, double sign, const Eigen::MatrixXi& exponents, LocalSystems& systems, std::size_t lane)
      : phi_(phi), sign_(sign), exponents_(exponents), s_(systems), lane_(lane), count_(exponents.cols()) {
    const std::size_t n = s_.rows, m = monomials(), lower_half = LaneCholesky::stored_elements(n - m);
    const std::size_t needed = (4 * n * m + 3 * m * m + 2 * m + 2 * n + lower_half) * stride;
    if (s_.work.size() < needed) s_.work.resize(needed);
    double* next = s_.work.data() + lane;
    const auto take = [&](std::size_t size) {
      double* p = next;
      next += size * stride;
      return p;
    };
    p_ = take(n * m), v_ = take(n * m), y_ = take(n * m), w_ = take(n * m);
    t_ = take(m * m), gram_ = take(m * m), small_ = take(m * m), a_ = take(m), b_ = take(m);
    unit_ = take(n), solution_ = take(n);
    matrix_ = LaneCholesky(take(lower_half), n - m);
  }

  /// Lanes that succeeded are 1.
  void run() {
    fill_monomials();
    reflect_monomials();
    assemble();
    project();
    project_unit();
    Vec good = matrix_.factor();
    substitute();
    good = hn::Min(good, finish());
    for (std::size_t i = 0; i < s_.rows; ++i)
      store(hn::IfThenElseZero(hn::Gt(good, set(0.5)), load(at(solution_, i))), s_.columns.data() + i * stride + lane_);
    double flags[stride];
    store(good, flags);
    for (std::size_t k = 0; k < hn::Lanes(Lanes()); ++k) s_.solved[lane_ + k] = flags[k] > 0.5;
  }

 private:
  HWY_INLINE std::size_t monomials() const { return M > 0 ? M : static_cast<std::size_t>(count_); }
  HWY_INLINE static double* at(double* p, std::size_t k) { return p + k * stride; }
  HWY_INLINE double* at(double* p, std::size_t row, std::size_t c) const {
    return p + (row * monomials() + c) * stride;
  }
  HWY_INLINE Vec presence(std::size_t row) const { return load(s_.presence.data() + row * stride + lane_); }
  HWY_INLINE const double* point(std::size_t row) const {
    return s_.coordinates.data() + row * static_cast<std::size_t>(s_.dimension) * stride + lane_;
  }

  void fill_monomials() {
    for (std::size_t i = 0; i < s_.rows; ++i)
      for (std::size_t c = 0; c < monomials(); ++c) {
        Vec value = presence(i);
        for (int axis = 0; axis < s_.dimension; ++axis)
          for (int k = 0; k < exponents_(axis, static_cast<Eigen::Index>(c)); ++k)
            value = hn::Mul(value, load(point(i) + static_cast<std::size_t>(axis) * stride));
        store(value, at(p_, i, c));
      }
  }

  HWY_INLINE Vec column_product(const double* a, std::size_t ca, const double* b, std::size_t cb,
                                std::size_t from) const {
    Vec sum = hn::Zero(Lanes());
    for (std::size_t i = from; i < s_.rows; ++i)
      sum = hn::MulAdd(load(a + (i * monomials() + ca) * stride), load(b + (i * monomials() + cb) * stride), sum);
    return sum;
  }

  /// Householder reflections: Q = I − V T Vᵀ maps the monomials into the first rows. A monomial that depends on
  /// the others in a lane gets no reflection there.
  void reflect_monomials() {
    const std::size_t n = s_.rows, m = monomials();
    const Vec zero = hn::Zero(Lanes());
    for (std::size_t c = 0; c < m; ++c) {
      const Vec squared = column_product(p_, c, p_, c, c);
      const auto usable = hn::Gt(squared, set(1e-14 * static_cast<double>(n)));
      const Vec pivot = load(at(p_, c, c));
      const Vec alpha = hn::CopySign(hn::Sqrt(squared), hn::Neg(pivot));
      for (std::size_t i = 0; i < n; ++i) {
        Vec v = i < c ? zero : load(at(p_, i, c));
        if (i == c) v = hn::Sub(v, alpha);
        store(hn::IfThenElseZero(usable, v), at(v_, i, c));
      }
      const Vec length = column_product(v_, c, v_, c, c);
      const Vec tau = hn::IfThenElseZero(usable, hn::Div(set(2.0), hn::IfThenElse(usable, length, set(1.0))));
      for (std::size_t other = c + 1; other < m; ++other) {
        const Vec factor = hn::Mul(tau, column_product(v_, c, p_, other, c));
        for (std::size_t i = c; i < n; ++i)
          store(hn::NegMulAdd(factor, load(at(v_, i, c)), load(at(p_, i, other))), at(p_, i, other));
      }
      for (std::size_t r = 0; r < m; ++r) store(zero, at(t_, r, c));
      store(tau, at(t_, c, c));
      for (std::size_t r = 0; r < c; ++r) store(column_product(v_, r, v_, c, c), at(gram_, r, c));
      for (std::size_t r = 0; r < c; ++r) {
        Vec sum = zero;
        for (std::size_t k = r; k < c; ++k) sum = hn::MulAdd(load(at(t_, r, k)), load(at(gram_, k, c)), sum);
        store(hn::Neg(hn::Mul(tau, sum)), at(t_, r, c));
      }
    }
  }

  HWY_INLINE Vec entry(std::size_t i, std::size_t j) const {
    const double* a = point(i);
    const double* b = point(j);
    Vec squared = set(tiny_squared);
    for (int axis = 0; axis < s_.dimension; ++axis, a += stride, b += stride) {
      const Vec d = hn::Sub(load(a), load(b));
      squared = hn::MulAdd(d, d, squared);
    }
    return hn::Mul(hn::Mul(set(sign_), phi_.value(squared)), hn::Mul(presence(i), presence(j)));
  }

  /// Computes A: the part below the monomials' rows is kept in tiles, and Y = A V is summed on the way.
  void assemble() {
    constexpr std::size_t most = M > 0 ? M : 32;
    const std::size_t n = s_.rows, m = monomials();
    const Vec one = set(1.0);
    for (std::size_t i = 0; i < n; ++i) {
      Vec sums[most];
      const Vec diagonal = hn::Add(load(s_.smoothing.data() + i * stride + lane_), hn::Sub(one, presence(i)));
      for (std::size_t c = 0; c < m; ++c) sums[c] = hn::Mul(diagonal, load(at(v_, i, c)));
      Vec own[most];
      for (std::size_t c = 0; c < m; ++c) own[c] = load(at(v_, i, c));
      for (std::size_t j = 0; j < i; ++j) {
        const Vec a = entry(i, j);
        for (std::size_t c = 0; c < m; ++c) {
          sums[c] = hn::MulAdd(a, load(at(v_, j, c)), sums[c]);
          store(hn::MulAdd(a, own[c], load(at(y_, j, c))), at(y_, j, c));
        }
        if (j >= m) store(a, matrix_.element(i - m, j - m));
      }
      for (std::size_t c = 0; c < m; ++c) store(sums[c], at(y_, i, c));
      if (i >= m) store(diagonal, matrix_.element(i - m, i - m));
    }
  }

  /// QᵀAQ = A − V Wᵀ − W Vᵀ with X = Y T, S = Tᵀ Vᵀ X and W = X − V S/2.
  void project() {
    constexpr std::size_t most = M > 0 ? M : 32;
    const std::size_t n = s_.rows, m = monomials();
    const Vec zero = hn::Zero(Lanes());
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t c = 0; c < m; ++c) {
        Vec sum = zero;
        for (std::size_t k = 0; k <= c; ++k) sum = hn::MulAdd(load(at(y_, i, k)), load(at(t_, k, c)), sum);
        store(sum, at(w_, i, c));
      }
    for (std::size_t r = 0; r < m; ++r)
      for (std::size_t c = 0; c < m; ++c) store(column_product(v_, r, w_, c, 0), at(gram_, r, c));
    for (std::size_t r = 0; r < m; ++r)
      for (std::size_t c = 0; c < m; ++c) {
        Vec sum = zero;
        for (std::size_t k = 0; k <= r; ++k) sum = hn::MulAdd(load(at(t_, k, r)), load(at(gram_, k, c)), sum);
        store(hn::Mul(set(0.5), sum), at(small_, r, c));
      }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t c = 0; c < m; ++c) {
        Vec sum = load(at(w_, i, c));
        for (std::size_t k = 0; k < m; ++k) sum = hn::NegMulAdd(load(at(v_, i, k)), load(at(small_, k, c)), sum);
        store(sum, at(w_, i, c));
      }
    for (std::size_t i = m; i < n; ++i) {
      Vec v[most], w[most];
      for (std::size_t c = 0; c < m; ++c) v[c] = load(at(v_, i, c)), w[c] = load(at(w_, i, c));
      for (std::size_t j = m; j <= i; ++j) {
        double* place = matrix_.element(i - m, j - m);
        Vec a = load(place), other = zero;
        for (std::size_t c = 0; c < m; ++c) {
          a = hn::NegMulAdd(v[c], load(at(w_, j, c)), a);
          other = hn::MulAdd(w[c], load(at(v_, j, c)), other);
        }
        store(hn::Sub(a, other), place);
      }
    }
  }

  /// The unit vector of row 0, reflected: Qᵀe₀ = e₀ − V Tᵀ (Vᵀ e₀).
  void project_unit() {
    const std::size_t n = s_.rows, m = monomials();
    for (std::size_t c = 0; c < m; ++c) {
      Vec sum = hn::Zero(Lanes());
      for (std::size_t k = 0; k <= c; ++k) sum = hn::MulAdd(load(at(t_, k, c)), load(at(v_, 0, k)), sum);
      store(sum, at(a_, c));
    }
    for (std::size_t i = 0; i < n; ++i) {
      Vec sum = i == 0 ? set(1.0) : hn::Zero(Lanes());
      for (std::size_t c = 0; c < m; ++c) sum = hn::NegMulAdd(load(at(v_, i, c)), load(at(a_, c)), sum);
      store(sum, at(unit_, i));
    }
  }

  /// solution = (L Lᵀ)⁻¹ unit below the monomials' rows, 0 above.
  void substitute() {
    const std::size_t m = monomials();
    for (std::size_t i = 0; i < m; ++i) store(hn::Zero(Lanes()), at(solution_, i));
    matrix_.solve(at(unit_, m), at(solution_, m));
  }

  /// Reflects back and scales; 1 where the result is usable.
  Vec finish() {
    const std::size_t n = s_.rows, m = monomials();
    const Vec zero = hn::Zero(Lanes());
    for (std::size_t c = 0; c < m; ++c) {
      Vec sum = zero;
      for (std::size_t i = m; i < n; ++i) sum = hn::MulAdd(load(at(v_, i, c)), load(at(solution_, i)), sum);
      store(sum, at(a_, c));
    }
    for (std::size_t c = 0; c < m; ++c) {
      Vec sum = zero;
      for (std::size_t k = c; k < m; ++k) sum = hn::MulAdd(load(at(t_, c, k)), load(at(a_, k)), sum);
      store(sum, at(b_, c));
    }
    Vec visible = zero;  // how much of the point is not polynomial
    for (std::size_t i = m; i < n; ++i) visible = hn::MulAdd(load(at(unit_, i)), load(at(unit_, i)), visible);
    for (std::size_t i = 0; i < n; ++i) {
      Vec sum = load(at(solution_, i));
      for (std::size_t c = 0; c < m; ++c) sum = hn::NegMulAdd(load(at(v_, i, c)), load(at(b_, c)), sum);
      store(sum, at(solution_, i));
    }
    const Vec own = load(at(solution_, 0));
    const auto usable = hn::And(hn::And(hn::Gt(own, zero), hn::Lt(own, set(1e300))), hn::Gt(visible, set(1e-8)));
    const Vec scale = hn::Div(set(1.0), hn::Sqrt(hn::IfThenElse(usable, own, set(1.0))));
    for (std::size_t i = 0; i < n; ++i) store(hn::Mul(load(at(solution_, i)), scale), at(solution_, i));
    return hn::IfThenElseZero(usable, set(1.0));
  }

  const Phi& phi_;
  double sign_;
  const Eigen::MatrixXi& exponents_;
  LocalSystems& s_;
  std::size_t lane_;
  Eigen::Index count_;
  double *p_, *v_, *y_, *w_, *t_, *gram_, *small_, *a_, *b_, *unit_, *solution_;
  LaneCholesky matrix_;
};

template <int M>
HWY_INLINE void solve_with(const Kernel& kernel, const Eigen::MatrixXi& exponents, LocalSystems& systems) {
  with_kernel(kernel, [&](const auto& phi) HWY_ATTR {
    for (std::size_t lane = 0; lane < stride; lane += hn::Lanes(Lanes()))
      Solver<M, std::decay_t<decltype(phi)>>(phi, kernel.sign(), exponents, systems, lane).run();
  });
}

void solve_simd(const Kernel& kernel, const Eigen::MatrixXi& exponents, LocalSystems& systems) {
  switch (exponents.cols()) {
    case 3:
      return solve_with<3>(kernel, exponents, systems);
    case 4:
      return solve_with<4>(kernel, exponents, systems);
    case 5:
      return solve_with<5>(kernel, exponents, systems);
    default:
      return solve_with<0>(kernel, exponents, systems);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isostack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isostack {

HWY_EXPORT(solve_simd);

void LocalSystems::resize(std::size_t row_count, int point_dimension) {
  rows = row_count;
  dimension = point_dimension;
  coordinates.assign(rows * static_cast<std::size_t>(dimension) * local_lanes, 0.0);
  presence.assign(rows * local_lanes, 0.0);
  smoothing.assign(rows * local_lanes, 0.0);
  columns.assign(rows * local_lanes, 0.0);
}

void solve_local_systems(const Kernel& kernel, const Eigen::MatrixXi& exponents, LocalSystems& systems) {
  HWY_DYNAMIC_DISPATCH(solve_simd)(kernel, exponents, systems);
}

}  // namespace isostack
#endif
