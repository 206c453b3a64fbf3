// The radial kernels on SIMD lanes. Included once per instruction set by the files that use
// Highway's foreach_target; not a header for anybody else.

#if defined(ISOSTACK_RADIAL_SIMD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSTACK_RADIAL_SIMD_INL_H_
#undef ISOSTACK_RADIAL_SIMD_INL_H_
#else
#define ISOSTACK_RADIAL_SIMD_INL_H_
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include "recon/solvers/radial_function.h"

HWY_BEFORE_NAMESPACE();
namespace isostack {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::ScalableTag<double>;
using Vec = hn::Vec<Lanes>;

/// Added to every squared distance, so that 1/r is finite and every term vanishes, at r = 0.
constexpr double tiny_squared = 1e-200;

HWY_INLINE Vec set(double value) { return hn::Set(Lanes(), value); }

/// 1/√s to full double precision. Where the hardware has a fast estimate (2⁻¹⁴) one step of
/// fourth order is three times as fast as a square root and a division.
HWY_INLINE Vec inverse_root(Vec squared) {
#if HWY_TARGET <= HWY_AVX3
  const Vec y = Vec{_mm512_rsqrt14_pd(squared.raw)};
  const Vec error = hn::NegMulAdd(hn::Mul(squared, y), y, set(1.0));
  const Vec series = hn::MulAdd(hn::MulAdd(set(0.3125), error, set(0.375)), error, set(0.5));
  return hn::MulAdd(hn::Mul(y, error), series, y);
#else
  return hn::Div(set(1.0), hn::Sqrt(squared));
#endif
}

HWY_INLINE Vec root(Vec squared) {
#if HWY_TARGET <= HWY_AVX3
  const Vec y = Vec{_mm512_rsqrt14_pd(squared.raw)};
  const Vec r = hn::Mul(squared, y);
  const Vec error = hn::NegMulAdd(r, y, set(1.0));
  const Vec series = hn::MulAdd(hn::MulAdd(set(0.3125), error, set(0.375)), error, set(0.5));
  return hn::MulAdd(hn::Mul(r, error), series, r);
#else
  return hn::Sqrt(squared);
#endif
}

/// φ, φ'/r and (φ'/r)'/r at one vector of squared distances.
struct RadialTerms {
  Vec value, slope, curvature;
};

struct FirstPower {  // r
  HWY_INLINE Vec value(Vec squared) const { return root(squared); }
  HWY_INLINE RadialTerms terms(Vec squared) const {
    const Vec inverse = inverse_root(squared);
    return {hn::Mul(squared, inverse), inverse, hn::Neg(hn::Mul(inverse, hn::Mul(inverse, inverse)))};
  }
};

struct ThirdPower {  // r³
  HWY_INLINE Vec value(Vec squared) const { return hn::Mul(squared, root(squared)); }
  HWY_INLINE RadialTerms terms(Vec squared) const {
    const Vec inverse = inverse_root(squared);
    const Vec distance = hn::Mul(squared, inverse);
    return {hn::Mul(squared, distance), hn::Mul(set(3.0), distance), hn::Mul(set(3.0), inverse)};
  }
};

struct ThinPlate {  // r² log r
  HWY_INLINE Vec value(Vec squared) const { return hn::Mul(hn::Mul(set(0.5), squared), hn::Log(Lanes(), squared)); }
  HWY_INLINE RadialTerms terms(Vec squared) const {
    const Vec log = hn::Log(Lanes(), squared);
    return {hn::Mul(hn::Mul(set(0.5), squared), log), hn::Add(log, set(1.0)), hn::Div(set(2.0), squared)};
  }
};

struct AnyPower {  // r^p, or r^p log r for even p
  int power;
  bool logarithmic;

  HWY_INLINE Vec monomial(Vec squared, int exponent) const {
    Vec result = exponent % 2 == 0 ? set(1.0) : root(squared);
    int reached = exponent % 2 == 0 ? 0 : 1;
    for (; reached < exponent; reached += 2) result = hn::Mul(result, squared);
    for (; reached > exponent; reached -= 2) result = hn::Div(result, squared);
    return result;
  }
  HWY_INLINE Vec value(Vec squared) const {
    const Vec result = monomial(squared, power);
    return logarithmic ? hn::Mul(result, hn::Mul(set(0.5), hn::Log(Lanes(), squared))) : result;
  }
  HWY_INLINE RadialTerms terms(Vec squared) const {
    const Vec p = set(power);
    const Vec slope = monomial(squared, power - 2), curvature = monomial(squared, power - 4);
    if (!logarithmic) return {value(squared), hn::Mul(p, slope), hn::Mul(set(power * (power - 2.0)), curvature)};
    const Vec log = hn::Mul(set(0.5), hn::Log(Lanes(), squared));
    const Vec inner = hn::MulAdd(p, log, set(1.0));
    return {value(squared), hn::Mul(slope, inner), hn::Mul(curvature, hn::MulAdd(set(power - 2.0), inner, p))};
  }
};

/// Calls `use` with the functor for a kernel, so that the common kernels' loops are specialised.
template <class Use>
HWY_INLINE void with_kernel(const Kernel& kernel, const Use& use) {
  if (!kernel.logarithmic && kernel.power == 1) return use(FirstPower{});
  if (!kernel.logarithmic && kernel.power == 3) return use(ThirdPower{});
  if (kernel.logarithmic && kernel.power == 2) return use(ThinPlate{});
  return use(AnyPower{kernel.power, kernel.logarithmic});
}

}  // namespace HWY_NAMESPACE
}  // namespace isostack
HWY_AFTER_NAMESPACE();

#endif
