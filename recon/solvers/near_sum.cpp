#include "recon/solvers/near_sum.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "recon/solvers/near_sum.cpp"
#include <hwy/foreach_target.h>  // compiles the SIMD part once per instruction set

#include "recon/solvers/radial_simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isostack {
namespace HWY_NAMESPACE {

struct Offsets {
  Vec x, y, z, squared;
};

HWY_INLINE Offsets offsets(Vec tx, Vec ty, Vec tz, Vec sx, Vec sy, Vec sz, Vec base) {
  const Vec x = hn::Sub(tx, sx), y = hn::Sub(ty, sy), z = hn::Sub(tz, sz);
  return {x, y, z, hn::MulAdd(x, x, hn::MulAdd(y, y, hn::MulAdd(z, z, base)))};
}

HWY_INLINE double total(Vec v) { return hn::GetLane(hn::SumOfLanes(Lanes(), v)); }

/// Four targets at a time share the loads of the sources.
template <class Phi>
HWY_INLINE void add_values(const Phi& phi, double shift_squared, const PointArrays& s, const double* weights,
                           const PointArrays& t, const SumArrays& sums) {
  const Lanes tag;
  const Vec base = set(shift_squared + tiny_squared);
  for (std::size_t i = 0; i < t.count; i += 4) {
    const std::size_t i1 = std::min(i + 1, t.count - 1), i2 = std::min(i + 2, t.count - 1),
                      i3 = std::min(i + 3, t.count - 1);
    const Vec x0 = set(t.x[i]), y0 = set(t.y[i]), z0 = set(t.z[i]);
    const Vec x1 = set(t.x[i1]), y1 = set(t.y[i1]), z1 = set(t.z[i1]);
    const Vec x2 = set(t.x[i2]), y2 = set(t.y[i2]), z2 = set(t.z[i2]);
    const Vec x3 = set(t.x[i3]), y3 = set(t.y[i3]), z3 = set(t.z[i3]);
    Vec a0 = hn::Zero(tag), a1 = a0, a2 = a0, a3 = a0;
    for (std::size_t j = 0; j < s.count; j += hn::Lanes(tag)) {
      const Vec x = hn::LoadU(tag, s.x + j), y = hn::LoadU(tag, s.y + j), z = hn::LoadU(tag, s.z + j),
                w = hn::LoadU(tag, weights + j);
      a0 = hn::MulAdd(w, phi.value(offsets(x0, y0, z0, x, y, z, base).squared), a0);
      a1 = hn::MulAdd(w, phi.value(offsets(x1, y1, z1, x, y, z, base).squared), a1);
      a2 = hn::MulAdd(w, phi.value(offsets(x2, y2, z2, x, y, z, base).squared), a2);
      a3 = hn::MulAdd(w, phi.value(offsets(x3, y3, z3, x, y, z, base).squared), a3);
    }
    sums.value[i] += total(a0);
    if (i + 1 < t.count) sums.value[i + 1] += total(a1);
    if (i + 2 < t.count) sums.value[i + 2] += total(a2);
    if (i + 3 < t.count) sums.value[i + 3] += total(a3);
  }
}

template <class Phi>
HWY_INLINE void add_gradients(const Phi& phi, double shift_squared, const PointArrays& s, const double* weights,
                              const PointArrays& t, const SumArrays& sums) {
  const Lanes tag;
  const Vec base = set(shift_squared + tiny_squared);
  for (std::size_t i = 0; i < t.count; i += 2) {
    const std::size_t k = std::min(i + 1, t.count - 1);
    const Vec x0 = set(t.x[i]), y0 = set(t.y[i]), z0 = set(t.z[i]);
    const Vec x1 = set(t.x[k]), y1 = set(t.y[k]), z1 = set(t.z[k]);
    Vec v0 = hn::Zero(tag), gx0 = v0, gy0 = v0, gz0 = v0, v1 = v0, gx1 = v0, gy1 = v0, gz1 = v0;
    for (std::size_t j = 0; j < s.count; j += hn::Lanes(tag)) {
      const Vec x = hn::LoadU(tag, s.x + j), y = hn::LoadU(tag, s.y + j), z = hn::LoadU(tag, s.z + j),
                w = hn::LoadU(tag, weights + j);
      const Offsets d0 = offsets(x0, y0, z0, x, y, z, base), d1 = offsets(x1, y1, z1, x, y, z, base);
      const RadialTerms f0 = phi.terms(d0.squared), f1 = phi.terms(d1.squared);
      const Vec s0 = hn::Mul(w, f0.slope), s1 = hn::Mul(w, f1.slope);
      v0 = hn::MulAdd(w, f0.value, v0);
      gx0 = hn::MulAdd(s0, d0.x, gx0);
      gy0 = hn::MulAdd(s0, d0.y, gy0);
      gz0 = hn::MulAdd(s0, d0.z, gz0);
      v1 = hn::MulAdd(w, f1.value, v1);
      gx1 = hn::MulAdd(s1, d1.x, gx1);
      gy1 = hn::MulAdd(s1, d1.y, gy1);
      gz1 = hn::MulAdd(s1, d1.z, gz1);
    }
    const auto add = [&](std::size_t target, Vec v, Vec gx, Vec gy, Vec gz) HWY_ATTR {
      sums.value[target] += total(v);
      sums.gradient[0][target] += total(gx);
      sums.gradient[1][target] += total(gy);
      sums.gradient[2][target] += total(gz);
    };
    add(i, v0, gx0, gy0, gz0);
    if (i + 1 < t.count) add(i + 1, v1, gx1, gy1, gz1);
  }
}

/// Value, gradient and s·I + c·d·dᵀ; both factors count as 0 at coincident points.
template <class Phi>
HWY_INLINE void add_hessians(const Phi& phi, double shift_squared, const PointArrays& s, const double* weights,
                             const PointArrays& t, const SumArrays& sums) {
  const Lanes tag;
  const Vec base = set(shift_squared + tiny_squared), floor = set(2 * tiny_squared);
  for (std::size_t i = 0; i < t.count; ++i) {
    const Vec tx = set(t.x[i]), ty = set(t.y[i]), tz = set(t.z[i]);
    Vec v = hn::Zero(tag), trace = v, gx = v, gy = v, gz = v, xx = v, yy = v, zz = v, yz = v, xz = v, xy = v;
    for (std::size_t j = 0; j < s.count; j += hn::Lanes(tag)) {
      const Vec w = hn::LoadU(tag, weights + j);
      const Offsets d =
          offsets(tx, ty, tz, hn::LoadU(tag, s.x + j), hn::LoadU(tag, s.y + j), hn::LoadU(tag, s.z + j), base);
      const RadialTerms f = phi.terms(d.squared);
      const auto apart = hn::Gt(d.squared, floor);
      const Vec slope = hn::Mul(w, hn::IfThenElseZero(apart, f.slope));
      const Vec curvature = hn::Mul(w, hn::IfThenElseZero(apart, f.curvature));
      v = hn::MulAdd(w, f.value, v);
      trace = hn::Add(trace, slope);
      gx = hn::MulAdd(slope, d.x, gx);
      gy = hn::MulAdd(slope, d.y, gy);
      gz = hn::MulAdd(slope, d.z, gz);
      const Vec cx = hn::Mul(curvature, d.x), cy = hn::Mul(curvature, d.y), cz = hn::Mul(curvature, d.z);
      xx = hn::MulAdd(cx, d.x, xx);
      yy = hn::MulAdd(cy, d.y, yy);
      zz = hn::MulAdd(cz, d.z, zz);
      yz = hn::MulAdd(cy, d.z, yz);
      xz = hn::MulAdd(cx, d.z, xz);
      xy = hn::MulAdd(cx, d.y, xy);
    }
    sums.value[i] += total(v);
    const Vec gradient[3] = {gx, gy, gz};
    for (int a = 0; a < 3; ++a) sums.gradient[a][i] += total(gradient[a]);
    const Vec hessian[6] = {hn::Add(xx, trace), hn::Add(yy, trace), hn::Add(zz, trace), yz, xz, xy};
    for (int a = 0; a < 6; ++a) sums.hessian[a][i] += total(hessian[a]);
  }
}

void add_near_sums_simd(const RadialFunction& function, const PointArrays& sources, const double* weights,
                        const PointArrays& targets, const SumArrays& sums) {
  with_kernel(function.kernel, [&](const auto& phi) HWY_ATTR {
    if (sums.hessian[0]) return add_hessians(phi, function.shift_squared, sources, weights, targets, sums);
    if (sums.gradient[0]) return add_gradients(phi, function.shift_squared, sources, weights, targets, sums);
    add_values(phi, function.shift_squared, sources, weights, targets, sums);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace isostack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isostack {

HWY_EXPORT(add_near_sums_simd);

SumArrays SumArrays::from(std::size_t first) const {
  SumArrays result = *this;
  result.value += first;
  for (double*& part : result.gradient)
    if (part) part += first;
  for (double*& part : result.hessian)
    if (part) part += first;
  return result;
}

void add_near_sums(const RadialFunction& function, const PointArrays& sources, const double* weights,
                   const PointArrays& targets, const SumArrays& sums) {
  if (sources.count == 0 || targets.count == 0) return;
  HWY_DYNAMIC_DISPATCH(add_near_sums_simd)(function, sources, weights, targets, sums);
}

}  // namespace isostack
#endif
