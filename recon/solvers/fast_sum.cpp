#include "recon/solvers/fast_sum.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "recon/solvers/leaf_sums.h"

namespace isostack {

namespace {

/// Room at the border, so that no point's cell depends on rounding.
constexpr double margin = 1e-4;

OctreeDomain domain_around(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd corners(a.rows(), 4);
  corners << a.rowwise().minCoeff(), a.rowwise().maxCoeff(), b.rowwise().minCoeff(), b.rowwise().maxCoeff();
  return OctreeDomain::around(corners, margin);
}

}  // namespace

std::array<bool, 3> flat_axes(const Octree& a, const Octree& b) {
  std::array<bool, 3> flat{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low_a, high_a] = std::minmax_element(a.coordinates(axis).begin(), a.coordinates(axis).end());
    const auto [low_b, high_b] = std::minmax_element(b.coordinates(axis).begin(), b.coordinates(axis).end());
    flat[static_cast<std::size_t>(axis)] = std::min(*low_a, *low_b) == std::max(*high_a, *high_b);
  }
  return flat;
}

FastSum::FastSum(const RadialFunction& function, const Eigen::MatrixXd& sources, const FastSumOptions& options)
    : function_(function),
      dimension_(sources.rows()),
      sources_(sources, OctreeDomain::fitted(sources, margin, options.leaf_size), options.leaf_size),
      interactions_(sources_, sources_),
      source_field_(function, sources_, flat_axes(sources_, sources_), options.far_field),
      target_field_(source_field_, sources_, interactions_) {}

FastSum::FastSum(const RadialFunction& function, const Eigen::MatrixXd& sources, const Eigen::MatrixXd& targets,
                 const FastSumOptions& options)
    : function_(function),
      dimension_(sources.rows()),
      sources_(sources, domain_around(sources, targets), options.leaf_size),
      own_targets_(Octree(targets, sources_.domain(), options.leaf_size, sources_.depth(), sources_.level_count() - 1)),
      interactions_(*own_targets_, sources_),
      source_field_(function, sources_, flat_axes(sources_, *own_targets_), options.far_field),
      target_field_(source_field_, *own_targets_, interactions_) {}

RadialSums FastSum::sums(const Eigen::VectorXd& weights, Derivatives derivatives) {
  std::vector<double> sorted(sources_.point_count());
  for (std::size_t k = 0; k < sorted.size(); ++k) sorted[k] = weights[sources_.order()[k]];
  source_field_.gather(sorted.data());
  target_field_.receive(source_field_);
  const auto terms_of = [this](int l, std::uint32_t cell) {
    LeafTerms terms;
    if (l >= SourceField::top_level) {
      terms.grid = &source_field_.level(l).grid;
      terms.far = target_field_.expansion(source_field_, l, cell);
    }
    terms.near = interactions_.levels[static_cast<std::size_t>(l)].near_of(cell);
    return terms;
  };
  return sum_at_leaves(function_, sources_, sorted, targets(), terms_of, dimension_, derivatives);
}

std::size_t FastSum::bytes() const {
  return source_field_.bytes() + target_field_.bytes(source_field_) + sources_.point_count() * 64;
}

}  // namespace isostack
