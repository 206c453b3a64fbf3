#include "recon/solvers/fast_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "recon/solvers/direct_sum.h"
#include "recon/solvers/local_fields.h"
#include "recon/solvers/octree.h"
#include "recon/solvers/source_field.h"

namespace isostack {

namespace {

constexpr int first_order = 6, most_order = 14;
constexpr int leaf_size = 90;
constexpr double error_per_order = 0.2;  ///< about what one more node leaves of the error

/// Points near the centres, where values matter: centres moved by fixed random fractions of the
/// extent, every other one by much less.
Eigen::MatrixXd sample_near(const Eigen::MatrixXd& centres) {
  constexpr Eigen::Index count = 256;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double extent = (centres.rowwise().maxCoeff() - centres.rowwise().minCoeff()).maxCoeff();
  Eigen::MatrixXd sample(centres.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index axis = 0; axis < centres.rows(); ++axis)
      sample(axis, i) = centres(axis, i * centres.cols() / count) + (i % 2 ? 1e-2 : 1e-3) * extent * uniform(random);
  return sample;
}

}  // namespace

struct FastField::Sources {
  RadialFunction function;
  Eigen::MatrixXd centres;
  Eigen::VectorXd weights;
  Options options;
  Octree tree;
  std::vector<double> sorted_weights;

  Sources(const RadialFunction& summed, const Eigen::MatrixXd& at, const Eigen::VectorXd& with, const Options& given)
      : function(summed),
        centres(at),
        weights(with),
        options(given),
        tree(at, OctreeDomain::fitted(at, 2 * given.reach + 1e-4, leaf_size), leaf_size),
        sorted_weights(tree.point_count()) {
    for (std::size_t k = 0; k < sorted_weights.size(); ++k) sorted_weights[k] = weights[tree.order()[k]];
  }
};

/// The sources interpolated with one order.
struct FastField::Gathered {
  int order;
  SourceField field;
  LocalFields locals;
  double sampled_error = 0;

  // A flat axis would tie the points to the centres' plane; a field is asked anywhere.
  Gathered(const Sources& from, int with_order)
      : order(with_order),
        field(from.function, from.tree, {false, from.centres.rows() < 2, from.centres.rows() < 3},
              {.order = with_order, .order_growth = 1, .most_order = most_order}),
        locals(field, from.options.kept_bytes) {
    field.gather(from.sorted_weights.data());
  }
};

FastField::FastField(const Kernel& kernel, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                     const Options& options)
    : FastField(RadialFunction{kernel, 0}, centres, weights, options) {}

FastField::FastField(const RadialFunction& function, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                     const Options& options)
    : sources_(std::make_unique<Sources>(function, centres, weights, options)) {
  choose_order();
}

FastField::~FastField() = default;
FastField::FastField(FastField&&) noexcept = default;
FastField& FastField::operator=(FastField&&) noexcept = default;

/// Goes up by as many orders as the error seems to need, and stops where rounding keeps it from
/// falling: as rounding grows with the order, one skipped below may then be the best.
void FastField::choose_order() {
  const Eigen::MatrixXd sample = sample_near(sources_->centres);
  const Eigen::VectorXd expected =
      direct_sums(sources_->function, sources_->centres, sources_->weights, sample, Derivatives::none).values;
  const auto attempt = [&](int order) {
    auto next = std::make_unique<Gathered>(*sources_, order);
    const double error = (fast_sums(*next, sample, Derivatives::none).values - expected).cwiseAbs().maxCoeff();
    next->sampled_error = error;
    if (!gathered_ || error < gathered_->sampled_error) gathered_ = std::move(next);
    return error;
  };
  const double tolerance = sources_->options.tolerance;
  std::vector<int> tried;
  double last_error = std::numeric_limits<double>::infinity();
  for (int order = first_order;;) {
    const double error = attempt(order);
    tried.push_back(order);
    if (error <= tolerance) return;
    if (error > last_error / 2 || order == most_order) {
      const int skipped = gathered_->order - 1;
      if (std::find(tried.begin(), tried.end(), skipped) == tried.end() && skipped > first_order) attempt(skipped);
      return;
    }
    last_error = error;
    const double missing = std::log(tolerance / error) / std::log(error_per_order);
    order = static_cast<int>(std::min<double>(most_order, order + std::max(1.0, std::round(missing))));
  }
}

double FastField::sampled_error() const { return gathered_->sampled_error; }
int FastField::order() const { return gathered_->order; }

bool FastField::is_direct(const Eigen::MatrixXd& points) const {
  if (points.cols() == 0) return true;
  const auto pairs = static_cast<std::size_t>(points.cols()) * sources_->tree.point_count();
  const OctreeDomain& domain = sources_->tree.domain();
  return pairs <= sources_->options.direct_pairs || !domain.contains(points.rowwise().minCoeff()) ||
         !domain.contains(points.rowwise().maxCoeff());
}

RadialSums FastField::sums(const Eigen::MatrixXd& points, Derivatives derivatives) const {
  if (is_direct(points))
    return direct_sums(sources_->function, sources_->centres, sources_->weights, points, derivatives);
  return fast_sums(*gathered_, points, derivatives);
}

RadialSums FastField::fast_sums(Gathered& from, const Eigen::MatrixXd& points, Derivatives derivatives) const {
  const Octree targets(points, sources_->tree);
  const LocalFields::Leaves leaves = from.locals.at(targets);
  const auto terms_of = [&](int l, std::uint32_t cell) {
    const LocalFields::Leaf& leaf = *leaves[static_cast<std::size_t>(l)][cell];
    return LeafTerms{&from.field.level(l).grid, {leaf.far.data(), 1}, leaf.near};
  };
  return sum_at_leaves(sources_->function, sources_->tree, sources_->sorted_weights, targets, terms_of, points.rows(),
                       derivatives);
}

}  // namespace isostack
