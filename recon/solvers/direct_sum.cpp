#include "recon/solvers/direct_sum.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/solvers/near_sum.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "recon/solvers/direct_sum.cpp"
#include <hwy/foreach_target.h>  // compiles the SIMD part once per instruction set

#include "recon/solvers/radial_simd-inl.h"

#ifndef ISOSTACK_DIRECT_SUM_ONCE
#define ISOSTACK_DIRECT_SUM_ONCE
namespace isostack {

/// Points of any dimension as one array per axis, relative to a common centre.
struct AxisArrays {
  std::size_t stride = 0;
  std::vector<double> axes;
  const double* axis(std::size_t a) const { return axes.data() + a * stride; }
};

/// A part of the sources.
struct SourcePart {
  const AxisArrays& points;
  const double* weights;
  std::size_t first, last;
};

}  // namespace isostack
#endif

HWY_BEFORE_NAMESPACE();
namespace isostack {
namespace HWY_NAMESPACE {

/// Adds to sums[0] the value, and to sums[1 + a] the derivative along each axis a, of any number of axes, at a target.
void add_at_target(const RadialFunction& function, const SourcePart& sources, const double* target,
                   std::size_t axis_count, bool with_gradient, double* sums) {
  constexpr std::size_t most_axes = 6;
  const Lanes tag;
  with_kernel(function.kernel, [&](const auto& phi) HWY_ATTR {
    const Vec base = set(function.shift_squared + tiny_squared);
    Vec value = hn::Zero(tag), gradient[most_axes];
    for (Vec& part : gradient) part = hn::Zero(tag);
    for (std::size_t j = sources.first; j < sources.last; j += hn::Lanes(tag)) {
      Vec squared = base, offset[most_axes];
      for (std::size_t a = 0; a < axis_count; ++a) {
        offset[a] = hn::Sub(set(target[a]), hn::LoadU(tag, sources.points.axis(a) + j));
        squared = hn::MulAdd(offset[a], offset[a], squared);
      }
      const RadialTerms terms = phi.terms(squared);
      const Vec w = hn::LoadU(tag, sources.weights + j), slope = hn::Mul(w, terms.slope);
      value = hn::MulAdd(w, terms.value, value);
      for (std::size_t a = 0; a < axis_count; ++a) gradient[a] = hn::MulAdd(slope, offset[a], gradient[a]);
    }
    sums[0] += hn::GetLane(hn::SumOfLanes(tag, value));
    for (std::size_t a = 0; a < axis_count && with_gradient; ++a)
      sums[1 + a] += hn::GetLane(hn::SumOfLanes(tag, gradient[a]));
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace isostack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isostack {

HWY_EXPORT(add_at_target);

namespace {

constexpr std::size_t target_block = 32, source_block = 1024;  // a block of sources stays in the first-level cache

AxisArrays arrays_of(const Eigen::MatrixXd& points, const Eigen::VectorXd& centre) {
  AxisArrays arrays;
  const auto count = static_cast<std::size_t>(points.cols());
  arrays.stride = (count + source_padding - 1) / source_padding * source_padding;
  const auto axis_count = static_cast<std::size_t>(std::max<Eigen::Index>(3, points.rows()));
  arrays.axes.assign(arrays.stride * axis_count, 0.0);  // missing axes are 0
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    for (Eigen::Index a = 0; a < points.rows(); ++a)
      arrays.axes[static_cast<std::size_t>(a) * arrays.stride + static_cast<std::size_t>(i)] = points(a, i) - centre[a];
  return arrays;
}

PointArrays part_of(const AxisArrays& arrays, std::size_t first, std::size_t last) {
  return {arrays.axis(0) + first, arrays.axis(1) + first, arrays.axis(2) + first, last - first};
}

/// Sums at a block of targets: value, gradient, Hessian of each.
struct BlockSums {
  std::array<std::array<double, target_block>, 10> columns{};

  SumArrays arrays(Derivatives derivatives) {
    SumArrays result;
    result.value = columns[0].data();
    for (std::size_t a = 0; a < 3 && derivatives != Derivatives::none; ++a) result.gradient[a] = columns[1 + a].data();
    for (std::size_t a = 0; a < 6 && derivatives == Derivatives::second; ++a) result.hessian[a] = columns[4 + a].data();
    return result;
  }

  void store(std::size_t first, std::size_t last, RadialSums& sums) const {
    for (std::size_t i = first; i < last; ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const auto at = [&](Eigen::Index k) { return columns[static_cast<std::size_t>(k)][i - first]; };
      sums.values[column] = at(0);
      for (Eigen::Index a = 0; a < sums.gradients.rows(); ++a) sums.gradients(a, column) = at(1 + a);
      for (Eigen::Index a = 0; a < sums.hessians.rows(); ++a) sums.hessians(a, column) = at(4 + a);
    }
  }
};

void add_in_many_dimensions(const RadialFunction& function, const SourcePart& sources, const AxisArrays& targets,
                            std::size_t first, std::size_t last, std::size_t axis_count, bool with_gradient,
                            BlockSums& block) {
  for (std::size_t i = first; i < last; ++i) {
    std::array<double, 6> target{};
    std::array<double, 7> sums{};
    for (std::size_t a = 0; a < axis_count; ++a) target[a] = targets.axis(a)[i];
    HWY_DYNAMIC_DISPATCH(add_at_target)(function, sources, target.data(), axis_count, with_gradient, sums.data());
    for (std::size_t k = 0; k <= axis_count; ++k) block.columns[k][i - first] += sums[k];
  }
}

}  // namespace

RadialSums direct_sums(const RadialFunction& function, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                       const Eigen::MatrixXd& targets, Derivatives derivatives) {
  const auto axis_count = static_cast<std::size_t>(targets.rows());
  const auto target_count = static_cast<std::size_t>(targets.cols());
  if (axis_count > 6 || (axis_count > 3 && derivatives == Derivatives::second))
    throw InputError("direct sum", "points have more dimensions than can be summed",
                     "use at most 6, or 3 for second derivatives");
  RadialSums sums;
  sums.values = Eigen::VectorXd::Zero(targets.cols());
  if (derivatives != Derivatives::none) sums.gradients = Eigen::MatrixXd::Zero(targets.rows(), targets.cols());
  if (derivatives == Derivatives::second) sums.hessians = Eigen::MatrixXd::Zero(6, targets.cols());
  if (centres.cols() == 0 || target_count == 0) return sums;

  const Eigen::VectorXd centre = (centres.rowwise().minCoeff() + centres.rowwise().maxCoeff()) / 2;
  const AxisArrays from = arrays_of(centres, centre), to = arrays_of(targets, centre);
  std::vector<double> padded(from.stride, 0.0);
  std::copy(weights.begin(), weights.end(), padded.begin());
  tbb::parallel_for(std::size_t{0}, (target_count + target_block - 1) / target_block, [&](std::size_t b) {
    const std::size_t first = b * target_block, last = std::min(first + target_block, target_count);
    BlockSums block;
    for (std::size_t s = 0; s < from.stride; s += source_block) {
      const std::size_t end = std::min(s + source_block, from.stride);
      if (axis_count <= 3)
        add_near_sums(function, part_of(from, s, end), padded.data() + s, part_of(to, first, last),
                      block.arrays(derivatives));
      else
        add_in_many_dimensions(function, {from, padded.data(), s, end}, to, first, last, axis_count,
                               derivatives != Derivatives::none, block);
    }
    block.store(first, last, sums);
  });
  return sums;
}

RadialSums direct_sums(const Kernel& kernel, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                       const Eigen::MatrixXd& targets, Derivatives derivatives) {
  return direct_sums(RadialFunction{kernel, 0}, centres, weights, targets, derivatives);
}

Eigen::VectorXd direct_sum(const Kernel& kernel, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                           const Eigen::MatrixXd& targets) {
  return direct_sums(kernel, centres, weights, targets, Derivatives::none).values;
}

Eigen::MatrixXd direct_sum_gradient(const Kernel& kernel, const Eigen::MatrixXd& centres,
                                    const Eigen::VectorXd& weights, const Eigen::MatrixXd& targets) {
  return direct_sums(kernel, centres, weights, targets, Derivatives::first).gradients;
}

}  // namespace isostack
#endif
