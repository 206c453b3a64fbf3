#include "recon/solvers/fast_field.h"

#include <algorithm>
#include <random>

#include "recon/solvers/direct_sum.h"
#include "recon/solvers/interactions.h"
#include "recon/solvers/octree.h"
#include "recon/solvers/source_field.h"
#include "recon/solvers/target_field.h"

namespace isostack {

namespace {

constexpr int first_order = 6, most_order = 14;

OctreeDomain domain_reaching(const Eigen::MatrixXd& centres, double reach) {
  const Eigen::VectorXd low = centres.rowwise().minCoeff(), high = centres.rowwise().maxCoeff();
  const double margin = reach * (high - low).maxCoeff();
  Eigen::MatrixXd corners(centres.rows(), 2);
  corners << low.array() - margin, high.array() + margin;
  return OctreeDomain::around(corners, 1e-4);
}

/// Points near the centres, where values matter: centres moved by a fixed random fraction of the extent.
Eigen::MatrixXd sample_near(const Eigen::MatrixXd& centres) {
  constexpr Eigen::Index count = 128;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.01, 0.01);
  const double extent = (centres.rowwise().maxCoeff() - centres.rowwise().minCoeff()).maxCoeff();
  Eigen::MatrixXd sample(centres.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index axis = 0; axis < centres.rows(); ++axis)
      sample(axis, i) = centres(axis, i * centres.cols() / count) + extent * uniform(random);
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
  std::unique_ptr<SourceField> field;
  double sampled_error = 0;

  Sources(const Kernel& kernel, const Eigen::MatrixXd& at, const Eigen::VectorXd& with, const Options& given)
      : function{kernel, 0},
        centres(at),
        weights(with),
        options(given),
        tree(at, domain_reaching(at, given.reach), 90),
        sorted_weights(tree.point_count()) {
    for (std::size_t k = 0; k < sorted_weights.size(); ++k) sorted_weights[k] = weights[tree.order()[k]];
  }

  void gather(int order) {
    // A flat axis would tie the points to the centres' plane; a field is asked anywhere.
    const std::array<bool, 3> flat{false, centres.rows() < 2, centres.rows() < 3};
    const FarFieldOptions far_field{.order = order, .order_growth = 1, .most_order = most_order};
    field = std::make_unique<SourceField>(function, tree, nullptr, flat, far_field);
    field->gather(sorted_weights.data());
  }
};

FastField::FastField(const Kernel& kernel, const Eigen::MatrixXd& centres, const Eigen::VectorXd& weights,
                     const Options& options)
    : sources_(std::make_unique<Sources>(kernel, centres, weights, options)) {
  const Eigen::MatrixXd sample = sample_near(centres);
  const Eigen::VectorXd expected = direct_sum(kernel, centres, weights, sample);
  for (int order = first_order; order <= most_order; order += 2) {
    sources_->gather(order);
    sources_->sampled_error = (sums(sample, Derivatives::none).values - expected).cwiseAbs().maxCoeff();
    if (sources_->sampled_error <= options.tolerance) break;
  }
}

FastField::~FastField() = default;
FastField::FastField(FastField&&) noexcept = default;
FastField& FastField::operator=(FastField&&) noexcept = default;

double FastField::sampled_error() const { return sources_->sampled_error; }

bool FastField::is_direct(const Eigen::MatrixXd& points) const {
  const auto pairs = static_cast<std::size_t>(points.cols()) * sources_->tree.point_count();
  if (pairs <= sources_->options.direct_pairs) return true;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (!sources_->tree.domain().contains(points.col(i))) return true;
  return false;
}

RadialSums FastField::sums(const Eigen::MatrixXd& points, Derivatives derivatives) const {
  const Octree& tree = sources_->tree;
  const Octree targets(points, tree.domain(), 30, tree.depth(), tree.level_count() - 1);
  const Interactions interactions(targets, tree);
  TargetField far(*sources_->field, targets, interactions);
  far.receive(*sources_->field);
  return sum_at_leaves(sources_->function, *sources_->field, far, targets, interactions, sources_->sorted_weights,
                       points.rows(), derivatives);
}

Eigen::VectorXd FastField::values(const Eigen::MatrixXd& points) const {
  if (is_direct(points)) return direct_sum(sources_->function.kernel, sources_->centres, sources_->weights, points);
  return sums(points, Derivatives::none).values;
}

Eigen::MatrixXd FastField::gradients(const Eigen::MatrixXd& points) const {
  if (is_direct(points))
    return direct_sum_gradient(sources_->function.kernel, sources_->centres, sources_->weights, points);
  return sums(points, Derivatives::first).gradients;
}

}  // namespace isostack
