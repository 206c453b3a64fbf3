#include "recon/solvers/kernel_operator.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <map>

#include "recon/solvers/direct_sum.h"

namespace isostack {

namespace {

constexpr Eigen::Index few_points = 6000;  ///< direct sums cost no more below, and are exact

/// A layer's points as padded arrays with their weights.
struct LayerArrays {
  std::array<std::vector<double>, 3> axes;
  std::vector<double> weights;

  LayerArrays(const PointLayers::Layer& layer, const Eigen::VectorXd& centre, const Eigen::VectorXd& all_weights) {
    const std::size_t count = layer.members.size();
    const std::size_t padded = (count + source_padding - 1) / source_padding * source_padding;
    for (std::size_t a = 0; a < 3; ++a) {
      axes[a].assign(padded, 0.0);
      if (static_cast<Eigen::Index>(a) >= layer.points.rows()) continue;
      const auto row = static_cast<Eigen::Index>(a);
      for (std::size_t k = 0; k < count; ++k)
        axes[a][k] = layer.points(row, static_cast<Eigen::Index>(k)) - centre[row];
    }
    weights.assign(padded, 0.0);
    for (std::size_t k = 0; k < count; ++k) weights[k] = all_weights[layer.members[k]];
  }
};

}  // namespace

PointLayers::PointLayers(const Eigen::MatrixXd& points) {
  const Eigen::Index near = std::min<Eigen::Index>(3, points.rows()), far = points.rows() - near;
  std::map<std::vector<double>, std::size_t> numbers;
  std::vector<std::size_t> layer_of(static_cast<std::size_t>(points.cols()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::VectorXd place = points.col(i).tail(far);
    const auto number = numbers.emplace(std::vector<double>(place.begin(), place.end()), numbers.size()).first->second;
    if (number == most_layers) {
      layers.clear();
      return;
    }
    if (number == layers.size()) layers.push_back({{}, {}, place});
    layers[number].members.push_back(static_cast<std::uint32_t>(i));
  }
  for (Layer& layer : layers) {
    layer.points.resize(near, static_cast<Eigen::Index>(layer.members.size()));
    for (std::size_t k = 0; k < layer.members.size(); ++k)
      layer.points.col(static_cast<Eigen::Index>(k)) = points.col(layer.members[k]).head(near);
  }
}

KernelOperator::KernelOperator(const Kernel& kernel, const Eigen::MatrixXd& points, const FastSumOptions& options)
    : kernel_(kernel), points_(points), layers_(points.cols() > few_points ? points : points.leftCols(0)) {
  for (const auto& target : layers_.layers)
    for (const auto& source : layers_.layers) {
      const RadialFunction function{kernel, (target.place - source.place).squaredNorm()};
      sums_.push_back(&target == &source ? std::make_unique<FastSum>(function, source.points, options)
                                         : std::make_unique<FastSum>(function, source.points, target.points, options));
    }
}

Eigen::VectorXd KernelOperator::times(const Eigen::VectorXd& weights) {
  if (sums_.empty()) {
    std::vector<std::uint32_t> all(static_cast<std::size_t>(points_.cols()));
    for (std::uint32_t k = 0; k < all.size(); ++k) all[k] = k;
    return direct_rows(kernel_, points_, weights, all);
  }
  Eigen::VectorXd result = Eigen::VectorXd::Zero(weights.size());
  const std::size_t count = layers_.layers.size();
  for (std::size_t s = 0; s < count; ++s) {
    const auto& members = layers_.layers[s].members;
    Eigen::VectorXd part(static_cast<Eigen::Index>(members.size()));
    for (std::size_t k = 0; k < members.size(); ++k) part[static_cast<Eigen::Index>(k)] = weights[members[k]];
    for (std::size_t t = 0; t < count; ++t) {
      const Eigen::VectorXd sums = sums_[t * count + s]->values(part);
      const auto& targets = layers_.layers[t].members;
      for (std::size_t k = 0; k < targets.size(); ++k) result[targets[k]] += sums[static_cast<Eigen::Index>(k)];
    }
  }
  return result;
}

std::size_t KernelOperator::layer_count(const Eigen::MatrixXd& points) {
  return points.cols() > few_points ? PointLayers(points).layers.size() : 0;
}

std::size_t KernelOperator::bytes() const {
  std::size_t sum = static_cast<std::size_t>(points_.size()) * sizeof(double);
  for (const auto& part : sums_) sum += part->bytes();
  return sum;
}

Eigen::VectorXd direct_rows(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& weights,
                            const std::vector<std::uint32_t>& sample) {
  const auto count = static_cast<Eigen::Index>(sample.size());
  Eigen::MatrixXd targets(points.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) targets.col(k) = points.col(sample[static_cast<std::size_t>(k)]);
  const PointLayers layers(points);
  if (layers.layers.empty()) return direct_sum(kernel, points, weights, targets);

  const Eigen::Index near = std::min<Eigen::Index>(3, points.rows()), far = points.rows() - near;
  const Eigen::VectorXd centre = (points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2;
  std::vector<LayerArrays> arrays;
  for (const auto& layer : layers.layers) arrays.emplace_back(layer, centre, weights);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(count);
  constexpr std::size_t target_block = 4, source_block = 1024;
  tbb::parallel_for(std::size_t{0}, (sample.size() + target_block * 8 - 1) / (target_block * 8), [&](std::size_t b) {
    for (std::size_t l = 0; l < arrays.size(); ++l)
      for (std::size_t s = 0; s < arrays[l].weights.size(); s += source_block)
        for (std::size_t k = b * target_block * 8; k < std::min(sample.size(), (b + 1) * target_block * 8); ++k) {
          // Targets of one block may lie in different layers, so they are summed one group at a time.
          std::size_t last = k + 1;
          const auto place = [&](std::size_t i) { return targets.col(static_cast<Eigen::Index>(i)).tail(far); };
          while (last < std::min({sample.size(), (b + 1) * target_block * 8, k + target_block}) &&
                 place(last) == place(k))
            ++last;
          std::array<std::array<double, target_block>, 3> t{};
          for (std::size_t i = k; i < last; ++i)
            for (Eigen::Index a = 0; a < near; ++a)
              t[static_cast<std::size_t>(a)][i - k] = targets(a, static_cast<Eigen::Index>(i)) - centre[a];
          SumArrays sums;
          sums.value = result.data() + k;
          const std::size_t n = std::min(source_block, arrays[l].weights.size() - s);
          add_near_sums({kernel, (layers.layers[l].place - place(k)).squaredNorm()},
                        {arrays[l].axes[0].data() + s, arrays[l].axes[1].data() + s, arrays[l].axes[2].data() + s, n},
                        arrays[l].weights.data() + s, {t[0].data(), t[1].data(), t[2].data(), last - k}, sums);
          k = last - 1;
        }
  });
  return result;
}

}  // namespace isostack
