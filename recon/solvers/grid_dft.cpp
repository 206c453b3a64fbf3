#include "recon/solvers/grid_dft.h"

#include <cmath>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "recon/solvers/grid_dft.cpp"
#include <hwy/foreach_target.h>  // compiles the SIMD part once per instruction set

#include "recon/solvers/radial_simd-inl.h"

#ifndef ISOSTACK_GRID_DFT_ONCE
#define ISOSTACK_GRID_DFT_ONCE
namespace isostack {

/// A line of complex lane vectors; stride in doubles.
struct LaneLine {
  double* real;
  double* imaginary;
  std::size_t stride;
};

/// Arrays of complex lane vectors.
struct Planes {
  double* real;
  double* imaginary;
  LaneLine line(std::size_t offset, std::size_t stride) const {
    return {real + offset * sibling_lanes, imaginary + offset * sibling_lanes, stride * sibling_lanes};
  }
};

}  // namespace isostack
#endif

HWY_BEFORE_NAMESPACE();
namespace isostack {
namespace HWY_NAMESPACE {

/// Complex line of `inputs` values to all frequencies. `Inverse` turns the sign of the exponent.
/// Frequencies k and n − k share their products.
template <bool Inverse>
HWY_INLINE void transform_line(const GridDft::Axis& axis, int inputs, LaneLine in, int outputs, LaneLine out) {
  const Lanes tag;
  const int n = axis.size;
  Vec sum_re = hn::Zero(tag), sum_im = sum_re;
  for (int j = 0; j < inputs; ++j) {
    sum_re = hn::Add(sum_re, hn::LoadU(tag, in.real + static_cast<std::size_t>(j) * in.stride));
    sum_im = hn::Add(sum_im, hn::LoadU(tag, in.imaginary + static_cast<std::size_t>(j) * in.stride));
  }
  hn::StoreU(sum_re, tag, out.real);
  hn::StoreU(sum_im, tag, out.imaginary);
  for (int k = 1; 2 * k < n && k < outputs; ++k) {
    const double* cosines = axis.cosines.data() + k * n;
    const double* sines = axis.sines.data() + k * n;
    Vec re_cos = hn::Zero(tag), re_sin = re_cos, im_cos = re_cos, im_sin = re_cos;
    for (int j = 0; j < inputs; ++j) {
      const Vec re = hn::LoadU(tag, in.real + static_cast<std::size_t>(j) * in.stride);
      const Vec im = hn::LoadU(tag, in.imaginary + static_cast<std::size_t>(j) * in.stride);
      const Vec c = set(cosines[j]), s = set(Inverse ? -sines[j] : sines[j]);
      re_cos = hn::MulAdd(re, c, re_cos);
      re_sin = hn::MulAdd(re, s, re_sin);
      im_cos = hn::MulAdd(im, c, im_cos);
      im_sin = hn::MulAdd(im, s, im_sin);
    }
    const auto store = [&](int place, Vec re, Vec im) HWY_ATTR {
      if (place >= outputs) return;
      hn::StoreU(re, tag, out.real + static_cast<std::size_t>(place) * out.stride);
      hn::StoreU(im, tag, out.imaginary + static_cast<std::size_t>(place) * out.stride);
    };
    store(k, hn::Add(re_cos, im_sin), hn::Sub(im_cos, re_sin));
    store(n - k, hn::Sub(re_cos, im_sin), hn::Add(im_cos, re_sin));
  }
}

/// Real line to the half spectrum.
HWY_INLINE void real_line(const GridDft::Axis& axis, int inputs, const double* in, LaneLine out) {
  const Lanes tag;
  const int n = axis.size;
  for (int k = 0; 2 * k < n; ++k) {
    Vec re = hn::Zero(tag), im = re;
    for (int j = 0; j < inputs; ++j) {
      const Vec v = hn::LoadU(tag, in + static_cast<std::size_t>(j) * sibling_lanes);
      re = hn::MulAdd(v, set(axis.cosines[static_cast<std::size_t>(k * n + j)]), re);
      im = hn::NegMulAdd(v, set(axis.sines[static_cast<std::size_t>(k * n + j)]), im);
    }
    hn::StoreU(re, tag, out.real + static_cast<std::size_t>(k) * out.stride);
    hn::StoreU(im, tag, out.imaginary + static_cast<std::size_t>(k) * out.stride);
  }
}

/// Half spectrum to a real line.
HWY_INLINE void real_line_back(const GridDft::Axis& axis, LaneLine in, int outputs, double* out) {
  const Lanes tag;
  const int n = axis.size;
  for (int j = 0; j < outputs; ++j) {
    Vec sum = hn::Zero(tag);
    for (int k = 1; 2 * k < n; ++k) {
      const Vec re = hn::LoadU(tag, in.real + static_cast<std::size_t>(k) * in.stride);
      const Vec im = hn::LoadU(tag, in.imaginary + static_cast<std::size_t>(k) * in.stride);
      sum = hn::MulAdd(re, set(axis.cosines[static_cast<std::size_t>(k * n + j)]), sum);
      sum = hn::NegMulAdd(im, set(axis.sines[static_cast<std::size_t>(k * n + j)]), sum);
    }
    hn::StoreU(hn::MulAdd(set(2.0), sum, hn::LoadU(tag, in.real)), tag,
               out + static_cast<std::size_t>(j) * sibling_lanes);
  }
}

void forward_simd(const std::array<GridDft::Axis, 3>& axes, const std::array<int, 3>& inputs, const double* in,
                  Planes first, Planes second, Planes out) {
  const auto mx = static_cast<std::size_t>(inputs[0]), my = static_cast<std::size_t>(inputs[1]),
             mz = static_cast<std::size_t>(inputs[2]);
  const auto ny = static_cast<std::size_t>(axes[1].size), half = static_cast<std::size_t>(axes[2].size / 2 + 1);
  for (std::size_t lane = 0; lane < sibling_lanes; lane += hn::Lanes(Lanes())) {
    const auto shifted = [lane](Planes p) { return Planes{p.real + lane, p.imaginary + lane}; };
    const Planes a = shifted(first), b = shifted(second), c = shifted(out);
    for (std::size_t line = 0; line < mx * my; ++line)
      real_line(axes[2], inputs[2], in + line * mz * sibling_lanes + lane, a.line(line * half, 1));
    for (std::size_t i = 0; i < mx; ++i)
      for (std::size_t k = 0; k < half; ++k)
        transform_line<false>(axes[1], inputs[1], a.line(i * my * half + k, half), axes[1].size,
                              b.line(i * ny * half + k, half));
    for (std::size_t line = 0; line < ny * half; ++line)
      transform_line<false>(axes[0], inputs[0], b.line(line, ny * half), axes[0].size, c.line(line, ny * half));
  }
}

void inverse_simd(const std::array<GridDft::Axis, 3>& axes, const std::array<int, 3>& outputs, Planes in, Planes first,
                  Planes second, double* out) {
  const auto mx = static_cast<std::size_t>(outputs[0]), my = static_cast<std::size_t>(outputs[1]),
             mz = static_cast<std::size_t>(outputs[2]);
  const auto ny = static_cast<std::size_t>(axes[1].size), half = static_cast<std::size_t>(axes[2].size / 2 + 1);
  for (std::size_t lane = 0; lane < sibling_lanes; lane += hn::Lanes(Lanes())) {
    const auto shifted = [lane](Planes p) { return Planes{p.real + lane, p.imaginary + lane}; };
    const Planes a = shifted(in), b = shifted(second), c = shifted(first);
    for (std::size_t line = 0; line < ny * half; ++line)
      transform_line<true>(axes[0], axes[0].size, a.line(line, ny * half), outputs[0], b.line(line, ny * half));
    for (std::size_t i = 0; i < mx; ++i)
      for (std::size_t k = 0; k < half; ++k)
        transform_line<true>(axes[1], axes[1].size, b.line(i * ny * half + k, half), outputs[1],
                             c.line(i * my * half + k, half));
    for (std::size_t line = 0; line < mx * my; ++line)
      real_line_back(axes[2], c.line(line * half, 1), outputs[2], out + line * mz * sibling_lanes + lane);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isostack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isostack {

HWY_EXPORT(forward_simd);
HWY_EXPORT(inverse_simd);

GridDft::Axis::Axis(int n) : size(n) {
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j) {
      const double angle = 2 * std::numbers::pi * (k * j % n) / n;
      cosines.push_back(std::cos(angle));
      sines.push_back(std::sin(angle));
    }
}

GridDft::GridDft(const NodeGrid& grid) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    padded_[k] = 2 * grid.count(axis) - 1;
    axes_[k] = Axis(padded_[k]);
  }
  half_ = padded_[2] / 2 + 1;
}

void GridDft::forward(const std::array<int, 3>& inputs, const double* in, double* real, double* imaginary,
                      std::vector<double>& scratch) const {
  const std::size_t first = static_cast<std::size_t>(inputs[0] * inputs[1] * half_) * sibling_lanes;
  const std::size_t second = static_cast<std::size_t>(inputs[0] * padded_[1] * half_) * sibling_lanes;
  scratch.resize(2 * (first + second));
  double* s = scratch.data();
  HWY_DYNAMIC_DISPATCH(forward_simd)
  (axes_, inputs, in, {s, s + first}, {s + 2 * first, s + 2 * first + second}, {real, imaginary});
}

void GridDft::inverse(const std::array<int, 3>& outputs, double* real, double* imaginary, double* out,
                      std::vector<double>& scratch) const {
  const std::size_t first = static_cast<std::size_t>(outputs[0] * outputs[1] * half_) * sibling_lanes;
  const std::size_t second = static_cast<std::size_t>(outputs[0] * padded_[1] * half_) * sibling_lanes;
  scratch.resize(2 * (first + second));
  double* s = scratch.data();
  HWY_DYNAMIC_DISPATCH(inverse_simd)
  (axes_, outputs, {real, imaginary}, {s, s + first}, {s + 2 * first, s + 2 * first + second}, out);
}

}  // namespace isostack
#endif
