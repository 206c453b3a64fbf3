#include "recon/surface/layered_function.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/solvers/direct_sum.h"
#include "recon/solvers/fast_field.h"
#include "recon/solvers/kernel_operator.h"

namespace isostack {

namespace {

// Below, setting up the fast sums takes as long as the sums they save.
constexpr Eigen::Index least_centres_for_fast_sums = 3000;

}  // namespace

struct LayeredFunction::Layers {
  Kernel kernel;
  PointLayers points;
  std::vector<Eigen::VectorXd> weights;  ///< of each layer's members
  PolynomialBasis tail;
  Eigen::VectorXd tail_coefficients;
  Eigen::Index dimension;
};

namespace {

/// One layer as it is seen from a section.
struct LayerSum {
  RadialFunction function;
  const Eigen::MatrixXd& centres;
  const Eigen::VectorXd& weights;
  std::optional<FastField> fast;

  LayerSum(const RadialFunction& summed, const Eigen::MatrixXd& at, const Eigen::VectorXd& with,
           const FastField::Options& options)
      : function(summed), centres(at), weights(with) {
    if (at.cols() >= least_centres_for_fast_sums) fast.emplace(function, centres, weights, options);
  }
  RadialSums sums(const Eigen::Matrix3Xd& points, Derivatives derivatives) const {
    return fast ? fast->sums(points, derivatives) : direct_sums(function, centres, weights, points, derivatives);
  }
};

Eigen::AlignedBox3d box_round(const Eigen::MatrixXd& centres) {
  return {Eigen::Vector3d(centres.rowwise().minCoeff()), Eigen::Vector3d(centres.rowwise().maxCoeff())};
}

/// A layer's centres may fill a small part of what the layers fill together, and points may lie that far outside of it.
double reach_of(const Eigen::AlignedBox3d& layer, const Eigen::AlignedBox3d& all) {
  const double beyond = std::max((layer.min() - all.min()).maxCoeff(), (all.max() - layer.max()).maxCoeff());
  return (beyond + all.sizes().maxCoeff()) / std::max(layer.sizes().maxCoeff(), 1e-3 * all.sizes().maxCoeff());
}

Eigen::MatrixXd lifted(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& place) {
  Eigen::MatrixXd result(3 + place.size(), points.cols());
  result << points, place.replicate(1, points.cols());
  return result;
}

}  // namespace

LayeredFunction::LayeredFunction(const Kernel& kernel, const Eigen::MatrixXd& centres, const RadialWeights& solution) {
  if (centres.rows() < 3 || centres.cols() == 0)
    throw InputError("layers", "a section needs centres of at least three dimensions", "give bodies");
  auto layers = std::make_shared<Layers>(
      Layers{kernel, PointLayers(centres), {}, solution.tail, solution.tail_coefficients, centres.rows()});
  if (layers->points.layers.empty())
    throw InputError("layers", "there are more than " + std::to_string(PointLayers::most_layers) + " key shapes",
                     "give fewer");
  for (const PointLayers::Layer& layer : layers->points.layers) {
    Eigen::VectorXd& part = layers->weights.emplace_back(static_cast<Eigen::Index>(layer.members.size()));
    for (std::size_t k = 0; k < layer.members.size(); ++k)
      part[static_cast<Eigen::Index>(k)] = solution.weights[layer.members[k]];
  }
  layers_ = layers;
}

Eigen::Index LayeredFunction::dimension() const { return layers_->dimension; }

ScalarField LayeredFunction::section(const Eigen::VectorXd& place, double tolerance) const {
  if (place.size() + 3 != dimension())
    throw InputError("section", "its place has another number of coordinates than the key shapes'",
                     "give one per dimension beyond the third");
  const auto sums = std::make_shared<std::vector<LayerSum>>();
  const std::vector<PointLayers::Layer>& all = layers_->points.layers;
  Eigen::AlignedBox3d box;
  for (const PointLayers::Layer& layer : all) box.extend(box_round(layer.points));
  for (std::size_t l = 0; l < all.size(); ++l)
    sums->emplace_back(RadialFunction{layers_->kernel, (all[l].place - place).squaredNorm()}, all[l].points,
                       layers_->weights[l],
                       FastField::Options{.tolerance = tolerance / static_cast<double>(all.size()),
                                          .reach = reach_of(box_round(all[l].points), box)});
  ScalarField field;
  field.values = [layers = layers_, sums, place](const Eigen::Matrix3Xd& points) {
    Eigen::VectorXd total = layers->tail.values(lifted(points, place)) * layers->tail_coefficients;
    for (const LayerSum& part : *sums) total += part.sums(points, Derivatives::none).values;
    return total;
  };
  field.gradients = [layers = layers_, sums, place](const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3Xd total = layers->tail.gradients(lifted(points, place), layers->tail_coefficients).topRows(3);
    for (const LayerSum& part : *sums) total += part.sums(points, Derivatives::first).gradients;
    return total;
  };
  return field;
}

}  // namespace isostack
