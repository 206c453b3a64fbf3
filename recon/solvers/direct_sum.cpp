#include "recon/solvers/direct_sum.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "recon/solvers/direct_sum.cpp"
#include <hwy/foreach_target.h>  // compiles the SIMD part once per instruction set

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#ifndef ISOSTACK_DIRECT_SUM_PARTS
#define ISOSTACK_DIRECT_SUM_PARTS
namespace isostack {

/// Centres as one padded array per axis; padding has weight 0.
struct PackedCentres {
  int dimension = 0;
  std::size_t padded_count = 0;
  std::vector<double> axes;  ///< dimension × padded_count
  std::vector<double> weights;
  const double* axis(int d) const { return axes.data() + static_cast<std::size_t>(d) * padded_count; }
};

}  // namespace isostack
#endif

HWY_BEFORE_NAMESPACE();
namespace isostack {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using Vec = hn::Vec<Tag>;

Vec power_of(Vec distance, Vec squared, int power) {
  const Tag tag;
  Vec result = power % 2 == 0 ? hn::Set(tag, 1.0) : distance;
  int reached = power % 2 == 0 ? 0 : 1;
  for (; reached < power; reached += 2) result = hn::Mul(result, squared);
  for (; reached > power; reached -= 2) result = hn::Div(result, squared);
  return result;
}

/// φ(r) of a lane of squared distances (never 0: see `tiny`).
Vec kernel_value(const Kernel& kernel, Vec squared) {
  const Tag tag;
  const Vec monomial = power_of(hn::Sqrt(squared), squared, kernel.power);
  if (!kernel.logarithmic) return monomial;
  return hn::Mul(monomial, hn::Mul(hn::Set(tag, 0.5), hn::Log(tag, squared)));
}

/// φ'(r)/r.
Vec kernel_slope(const Kernel& kernel, Vec squared) {
  const Tag tag;
  const Vec monomial = power_of(hn::Sqrt(squared), squared, kernel.power - 2);
  const Vec power = hn::Set(tag, static_cast<double>(kernel.power));
  if (!kernel.logarithmic) return hn::Mul(power, monomial);
  const Vec log_r = hn::Mul(hn::Set(tag, 0.5), hn::Log(tag, squared));
  return hn::Mul(monomial, hn::MulAdd(power, log_r, hn::Set(tag, 1.0)));
}

// Keeps r = 0 harmless: every φ and every slope times its zero offset vanishes there.
constexpr double tiny = 1e-280;

Vec squared_distance(const PackedCentres& centres, const double* target, std::size_t j) {
  const Tag tag;
  Vec squared = hn::Set(tag, tiny);
  for (int d = 0; d < centres.dimension; ++d) {
    const Vec offset = hn::Sub(hn::Set(tag, target[d]), hn::LoadU(tag, centres.axis(d) + j));
    squared = hn::MulAdd(offset, offset, squared);
  }
  return squared;
}

double sum_value(const Kernel& kernel, const PackedCentres& centres, const double* target) {
  const Tag tag;
  Vec sum = hn::Zero(tag);
  for (std::size_t j = 0; j < centres.padded_count; j += hn::Lanes(tag)) {
    const Vec value = kernel_value(kernel, squared_distance(centres, target, j));
    sum = hn::MulAdd(hn::LoadU(tag, centres.weights.data() + j), value, sum);
  }
  return hn::GetLane(hn::SumOfLanes(tag, sum));
}

void sum_gradient(const Kernel& kernel, const PackedCentres& centres, const double* target, double* gradient) {
  const Tag tag;
  Vec sums[6] = {hn::Zero(tag), hn::Zero(tag), hn::Zero(tag), hn::Zero(tag), hn::Zero(tag), hn::Zero(tag)};
  for (std::size_t j = 0; j < centres.padded_count; j += hn::Lanes(tag)) {
    const Vec slope = kernel_slope(kernel, squared_distance(centres, target, j));
    const Vec factor = hn::Mul(hn::LoadU(tag, centres.weights.data() + j), slope);
    for (int d = 0; d < centres.dimension; ++d) {
      const Vec offset = hn::Sub(hn::Set(tag, target[d]), hn::LoadU(tag, centres.axis(d) + j));
      sums[d] = hn::MulAdd(factor, offset, sums[d]);
    }
  }
  for (int d = 0; d < centres.dimension; ++d) gradient[d] = hn::GetLane(hn::SumOfLanes(tag, sums[d]));
}

}  // namespace HWY_NAMESPACE
}  // namespace isostack
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isostack {

HWY_EXPORT(sum_value);
HWY_EXPORT(sum_gradient);

namespace {

PackedCentres pack(const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights) {
  constexpr std::size_t widest_lane = 8;
  PackedCentres packed;
  packed.dimension = static_cast<int>(centres.rows());
  const auto count = static_cast<std::size_t>(centres.cols());
  packed.padded_count = (count + widest_lane - 1) / widest_lane * widest_lane;
  packed.axes.assign(packed.padded_count * static_cast<std::size_t>(packed.dimension), 0.0);
  packed.weights.assign(packed.padded_count, 0.0);
  for (std::size_t j = 0; j < count; ++j) {
    packed.weights[j] = weights[static_cast<Eigen::Index>(j)];
    for (int d = 0; d < packed.dimension; ++d)
      packed.axes[static_cast<std::size_t>(d) * packed.padded_count + j] = centres(d, static_cast<Eigen::Index>(j));
  }
  return packed;
}

template <class PerTarget>
void for_each_target(Eigen::Index count, PerTarget per_target) {
  tbb::parallel_for(tbb::blocked_range<Eigen::Index>(0, count, 16), [&](const auto& range) {
    for (Eigen::Index i = range.begin(); i < range.end(); ++i) per_target(i);
  });
}

}  // namespace

Eigen::VectorXd direct_sum(const Kernel& kernel, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                           const Eigen::MatrixXd& targets) {
  const PackedCentres packed = pack(centres, weights);
  Eigen::VectorXd sums(targets.cols());
  for_each_target(targets.cols(), [&](Eigen::Index i) {
    sums[i] = HWY_DYNAMIC_DISPATCH(sum_value)(kernel, packed, targets.col(i).data());
  });
  return sums;
}

Eigen::MatrixXd direct_sum_gradient(const Kernel& kernel, const Eigen::MatrixXd& centres,
                                    const Eigen::VectorXd& weights, const Eigen::MatrixXd& targets) {
  const PackedCentres packed = pack(centres, weights);
  Eigen::MatrixXd gradients(targets.rows(), targets.cols());
  for_each_target(targets.cols(), [&](Eigen::Index i) {
    HWY_DYNAMIC_DISPATCH(sum_gradient)(kernel, packed, targets.col(i).data(), gradients.col(i).data());
  });
  return gradients;
}

}  // namespace isostack
#endif
