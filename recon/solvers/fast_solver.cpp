#include "recon/solvers/fast_solver.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"
#include "recon/solvers/box_tree.h"
#include "recon/solvers/memory_limit.h"
#include "recon/solvers/product_memory.h"
#include "recon/solvers/spanned_space.h"

namespace isostack {

namespace {

constexpr Eigen::Index most_direct = 20'000;  ///< constraints for which products that correct are summed term by term

/// Orders at which the operator stays definite and a sweep gains three digits, by measurement. The smoother
/// r³ needs a steep growth: its values at coarse cells are the largest, and their errors with them.
FastSumOptions inner_options(const Kernel& kernel) {
  if (kernel.power >= 3) return {.far_field = {.order = 7, .order_growth = 2, .most_order = 20}, .leaf_size = 90};
  return {.far_field = {.order = kernel.power == 2 ? 7 : 6, .order_growth = 1, .most_order = 13}, .leaf_size = 90};
}

FastSumOptions outer_options(const Kernel& kernel, double tolerance) {
  if (kernel.power >= 3)
    return {.far_field = {.order = tolerance < 1e-4 ? 9 : 8, .order_growth = 2, .most_order = 20}, .leaf_size = 90};
  return {.far_field = {.order = kernel.power == 2 ? 10 : 9, .order_growth = 1, .most_order = 14}, .leaf_size = 150};
}

/// Constraints to check: a fixed sample in ascending order, all if they are fewer.
std::vector<std::uint32_t> fixed_sample(std::size_t count, std::size_t wanted) {
  std::vector<std::uint32_t> sample(count);
  for (std::uint32_t k = 0; k < count; ++k) sample[k] = k;
  if (count <= wanted) return sample;
  std::mt19937 random(20240607);
  for (std::size_t k = 0; k < wanted; ++k) std::swap(sample[k], sample[k + random() % (count - k)]);
  sample.resize(wanted);
  std::sort(sample.begin(), sample.end());
  return sample;
}

const Eigen::MatrixXd& require_points(const Eigen::MatrixXd& points) {
  if (points.cols() == 0 || !points.allFinite())
    throw InputError("solve", "the constraints are none, or some of their coordinates are not numbers",
                     "give finite points");
  return points;
}

std::string place_of(const Eigen::VectorXd& point) {
  std::ostringstream text;
  text << "(";
  for (Eigen::Index a = 0; a < point.size(); ++a) text << (a ? ", " : "") << point[a];
  text << ")";
  return text.str();
}

}  // namespace

struct FastSolver::Iteration {
  Eigen::VectorXd weights;
  Eigen::VectorXd residual;  ///< without its polynomial part
  Eigen::VectorXd tail;      ///< coefficients of that part
  int iterations = 0;
  bool indefinite = false;
};

FastSolver::FastSolver(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& smoothing,
                       const FastSolverOptions& options, const Progress& progress)
    : kernel_(kernel), options_(options), basis_(kernel.tail_degree, require_points(points)) {
  predicted_bytes_ = required_bytes(points, kernel, options.preconditioner);
  require_memory(static_cast<std::size_t>(points.cols()), predicted_bytes_, options.memory_limit_bytes);
  const Eigen::MatrixXd spanned = reduced_to_span(points);
  order_ = curve_order(spanned);
  places_.resize(points.rows(), points.cols());
  points_.resize(spanned.rows(), points.cols());
  smoothing_.resize(smoothing.size());
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    places_.col(column) = points.col(order_[k]);
    points_.col(column) = spanned.col(order_[k]);
    if (smoothing.size() > 0) smoothing_[column] = smoothing[order_[k]];
  }
  Stopwatch tail_watch;
  tail_.emplace(basis_, places_);
  stages_.push_back({"tail", tail_watch.seconds(), 0});
  Stopwatch factor_watch;
  preconditioner_.emplace(kernel_, points_, smoothing_, tail_->determining_points(), options_.preconditioner, progress);
  stages_.push_back({"precondition", factor_watch.seconds(), preconditioner_->bytes()});
  inner_options_ = options_.inner.value_or(inner_options(kernel));
  outer_options_ = options_.outer.value_or(outer_options(kernel, options_.tolerance));
}

Eigen::VectorXd FastSolver::system_times(KernelOperator& product, const Eigen::VectorXd& weights) const {
  Eigen::VectorXd result = kernel_.sign() * product.times(weights);
  if (smoothing_.size() > 0) result += smoothing_.cwiseProduct(weights);
  return result;
}

/// Conjugate gradients from residual to a correction of the weights, until the residual is below `target`.
bool FastSolver::iterate(Iteration& state, double target, int most, const Progress& progress) {
  Eigen::VectorXd z = preconditioner_->apply(state.residual);
  Eigen::VectorXd direction = z;
  double rz = dot(state.residual, z);
  const double start = state.residual.cwiseAbs().maxCoeff();
  for (int k = 0; k < most; ++k) {
    Eigen::VectorXd image = system_times(*inner_, direction);
    const double curvature = dot(direction, image);
    if (!(curvature > 0)) {
      state.indefinite = true;
      return false;
    }
    const double step = rz / curvature;
    state.weights += step * direction;
    state.residual -= step * image;
    state.tail += tail_->remove_from(state.residual);
    ++state.iterations;
    const double largest = state.residual.cwiseAbs().maxCoeff();
    progress.report("solve", std::clamp(std::log(start / largest) / std::log(start / target), 0.0, 1.0));
    if (largest <= target) return true;
    z = preconditioner_->apply(state.residual);
    const double next = dot(state.residual, z);
    direction = z + next / rz * direction;
    rz = next;
  }
  return false;
}

/// The product that corrects: every term for few points, where that costs no more.
Eigen::VectorXd FastSolver::accurate_times(const Eigen::VectorXd& weights) {
  if (outer_is_direct()) {
    Eigen::VectorXd result =
        kernel_.sign() * direct_rows(kernel_, points_, weights, fixed_sample(order_.size(), order_.size()));
    if (smoothing_.size() > 0) result += smoothing_.cwiseProduct(weights);
    return result;
  }
  if (!outer_) outer_.emplace(kernel_, points_, outer_options_);
  return system_times(*outer_, weights);
}

/// Whether what is held would stay within the limit if the products grew by half, as two more orders make them.
bool FastSolver::may_grow() const {
  const std::size_t products = (inner_ ? inner_->bytes() : 0) + (outer_ ? outer_->bytes() : 0);
  return preconditioner_->bytes() + products + products / 2 <= options_.memory_limit_bytes;
}

/// A more accurate product, when the present one hides what is left of the residual.
bool FastSolver::raise_outer_order() {
  constexpr int most_order = 14;
  if (outer_is_direct() || outer_options_.far_field.order + 2 > most_order || !may_grow()) return false;
  outer_options_.far_field.order += 2;
  outer_options_.far_field.most_order = std::max(outer_options_.far_field.most_order, outer_options_.far_field.order);
  outer_.reset();
  return true;
}

/// The residual by the accurate product, its polynomial part moved to the tail.
void FastSolver::correct(Iteration& state, const Eigen::VectorXd& values) {
  state.residual = values;
  if (!state.weights.isZero(0)) state.residual -= accurate_times(state.weights);
  state.tail = tail_->remove_from(state.residual);
}

Solution FastSolver::solve(const Eigen::VectorXd& values, const Eigen::VectorXd& start, const Progress& progress) {
  Eigen::VectorXd f(values.size());
  Iteration state;
  state.weights = Eigen::VectorXd::Zero(values.size());
  for (std::size_t k = 0; k < order_.size(); ++k) {
    f[static_cast<Eigen::Index>(k)] = kernel_.sign() * values[order_[k]];
    if (start.size() > 0) state.weights[static_cast<Eigen::Index>(k)] = start[order_[k]];
  }
  if (start.size() > 0) tail_->remove_from(state.weights);  // earlier weights may belong to fewer points
  Stopwatch watch;
  Solution solution;
  refine(state, f, solution, progress);
  solution.stages.push_back(
      {"solve", watch.seconds(), (inner_ ? inner_->bytes() : 0) + (outer_ ? outer_->bytes() : 0)});
  solution.stages.insert(solution.stages.begin(), stages_.begin(), stages_.end());
  solution.iterations = state.iterations;
  solution.function.tail = basis_;
  solution.function.tail_coefficients = kernel_.sign() * state.tail;
  solution.function.weights.resize(values.size());
  for (std::size_t k = 0; k < order_.size(); ++k)
    solution.function.weights[order_[k]] = state.weights[static_cast<Eigen::Index>(k)];
  return solution;
}

/// Iterative refinement: sweeps of conjugate gradients between corrections by the accurate product.
/// Ends with the best weights found in `state`, checked by direct sums.
void FastSolver::refine(Iteration& state, const Eigen::VectorXd& values, Solution& solution, const Progress& progress) {
  constexpr int most_sweeps = 8, most_order = 12;
  Iteration best = state;
  double least = std::numeric_limits<double>::infinity();
  const auto accept = [&](double residual) {  // keeps the best state
    if (residual < least) least = residual, best = state;
    return residual <= options_.tolerance;
  };
  correct(state, values);
  if (state.weights.isZero(0)) {  // nothing worse than the tail alone is an answer
    least = state.residual.cwiseAbs().maxCoeff();
    best = state;
  }
  while (solution.sweeps < most_sweeps && state.iterations < options_.most_iterations) {
    const double largest = state.residual.cwiseAbs().maxCoeff();
    if (largest <= 0.9 * options_.tolerance) {
      if (accept(checked_residual(state, values, solution))) break;
      if (!raise_outer_order()) break;
      correct(state, values);
      continue;
    }
    if (!inner_) inner_.emplace(kernel_, points_, inner_options_);
    const Iteration before = state;
    const double target = std::max(largest * options_.sweep_reduction, 0.3 * options_.tolerance);
    const bool reached = iterate(state, target, options_.most_iterations - state.iterations, progress);
    ++solution.sweeps;
    if (state.indefinite) {  // too low an order: the interpolated operator is not definite
      const int iterations = state.iterations;
      state = before;
      state.iterations = iterations;
      if (inner_options_.far_field.order >= most_order || !may_grow()) break;
      ++inner_options_.far_field.order;
      inner_.reset();
      continue;
    }
    if (reached && target <= 0.3 * options_.tolerance * 1.0001 && accept(checked_residual(state, values, solution)))
      break;
    correct(state, values);
    const double after = state.residual.cwiseAbs().maxCoeff();
    if (after > 0.5 * largest) {  // stalled: the inner product hides what is left, or the outer one does
      if (accept(checked_residual(state, values, solution))) break;
      if (after > largest) {
        const int iterations = state.iterations;
        state = before;
        state.iterations = iterations;
      }
      const bool finer = inner_options_.far_field.order + 2 <= most_order && may_grow();
      if (finer) {
        inner_options_.far_field.order += 2;
        inner_.reset();
      }
      if (!raise_outer_order() && !finer) break;
      correct(state, values);
    }
  }
  if (least > options_.tolerance) accept(checked_residual(state, values, solution));
  const int iterations = state.iterations;
  state = best;
  state.iterations = iterations;
  solution.largest_residual = least;
  solution.converged = least <= options_.tolerance;
  if (solution.converged) solution.remark.clear();
}

/// The largest deviation at a fixed sample of constraints, summed term by term.
double FastSolver::checked_residual(const Iteration& state, const Eigen::VectorXd& values, Solution& solution) const {
  const auto sample = fixed_sample(order_.size(), static_cast<std::size_t>(options_.checked_constraints));
  const Eigen::VectorXd sums = direct_rows(kernel_, points_, state.weights, sample);
  Eigen::MatrixXd at(places_.rows(), sums.size());
  Eigen::VectorXd residual(sums.size());
  for (Eigen::Index k = 0; k < sums.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(sample[static_cast<std::size_t>(k)]);
    at.col(k) = places_.col(i);
    residual[k] = values[i] - kernel_.sign() * sums[k];
    if (smoothing_.size() > 0) residual[k] -= smoothing_[i] * state.weights[i];
  }
  residual -= basis_.values(at) * state.tail;
  Eigen::Index heaviest = 0;  // the residual itself is noise by then: the weights point at the cause
  state.weights.cwiseAbs().maxCoeff(&heaviest);
  solution.remark =
      state.iterations >= options_.most_iterations
          ? "the iterations allowed (" + std::to_string(options_.most_iterations) + ") are used up"
          : "near " + place_of(places_.col(heaviest)) + " constraints contradict each other or lie too close together";
  return residual.cwiseAbs().maxCoeff();
}

namespace {

/// Both products, after as many raises of their orders as solves of contours were seen to need.
std::size_t product_bytes(const Eigen::MatrixXd& points, const Kernel& kernel) {
  const auto bytes_of = [&](FastSumOptions options, int raise) {
    options.far_field.order += raise;
    const OctreeDomain domain = OctreeDomain::fitted(points, 1e-4, options.leaf_size);
    const ProductMemory memory = product_memory(Octree(points, domain, options.leaf_size), options.far_field);
    return memory.sources + memory.targets;
  };
  const int raise = kernel.power >= 3 ? 2 : 0;
  const std::size_t inner = bytes_of(inner_options(kernel), raise);
  return points.cols() <= most_direct ? inner : inner + bytes_of(outer_options(kernel, 0), raise);
}

}  // namespace

/// By measurement from 3,000 to 10⁶ constraints, with some room. In one layer the cells of the products are counted;
/// otherwise tables per pair of layers, cells per point and layer. Entries of the preconditioner: levels above the
/// finest add 40 %.
std::size_t FastSolver::required_bytes(const Eigen::MatrixXd& points, const Kernel& kernel,
                                       const CoarseToFineOptions& preconditioner) {
  const auto count = static_cast<std::size_t>(points.cols());
  const auto entries = static_cast<std::size_t>(1.45 * preconditioner.neighbours) + 1;
  const std::size_t held = (std::size_t{16} << 20) + count * (400 + entries * (sizeof(double) + sizeof(std::uint32_t)));
  const std::size_t layers = KernelOperator::layer_count(points);
  if (points.rows() <= 3 && layers == 1) return held + product_bytes(points, kernel);
  const double levels =
      std::min(1.0, static_cast<double>(count) / (25'000.0 * static_cast<double>(std::max<std::size_t>(layers, 1))));
  const auto table = static_cast<std::size_t>(levels * (kernel.power >= 3 ? 90e6 : 60e6));
  const std::size_t cells = kernel.power >= 3 ? 2400 : kernel.power == 2 ? 1900 : 1400;
  return held + layers * layers * table + layers * count * cells;
}

}  // namespace isostack
