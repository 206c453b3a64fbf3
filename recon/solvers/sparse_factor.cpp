#include "recon/solvers/sparse_factor.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>

#include "recon/solvers/local_columns.h"

namespace isostack {

namespace {

constexpr std::size_t lanes = LocalSystems::local_lanes;

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Exponents of all monomials of degree ≤ `degree` in n variables: n × count.
Eigen::MatrixXi monomial_exponents(int dimension, int degree) {
  std::vector<Eigen::VectorXi> all;
  Eigen::VectorXi exponents = Eigen::VectorXi::Zero(dimension);
  while (true) {
    if (exponents.sum() <= degree) all.push_back(exponents);
    int axis = 0;
    while (axis < dimension && exponents[axis] == degree) exponents[axis++] = 0;
    if (axis == dimension) break;
    ++exponents[axis];
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.sum() < b.sum(); });
  Eigen::MatrixXi result(dimension, static_cast<Eigen::Index>(all.size()));
  for (std::size_t q = 0; q < all.size(); ++q) result.col(static_cast<Eigen::Index>(q)) = all[q];
  return result;
}

/// A column's point followed by its predecessors.
using Column = std::vector<std::uint32_t>;

/// Loads columns into the lanes of `systems`; returns the factor each solved column must be multiplied by.
std::array<double, lanes> load_columns(const Kernel& kernel, const Eigen::MatrixXd& points,
                                       const Eigen::VectorXd& smoothing, const std::vector<Column>& columns,
                                       std::size_t monomials, LocalSystems& systems) {
  std::size_t rows = 0;
  for (const Column& column : columns) rows = std::max(rows, column.size());
  const auto dimension = static_cast<std::size_t>(points.rows());
  systems.resize(LocalSystems::padded_rows(rows, monomials), static_cast<int>(dimension));
  std::array<double, lanes> factors{};
  for (std::size_t lane = 0; lane < columns.size(); ++lane) {
    const Column& column = columns[lane];
    const auto own = points.col(column[0]);
    double reach = 0;
    for (const std::uint32_t j : column) reach = std::max(reach, (points.col(j) - own).squaredNorm());
    reach = std::sqrt(reach);
    const double unit = std::pow(reach, kernel.power);
    factors[lane] = 1 / std::sqrt(unit);
    for (std::size_t row = 0; row < column.size(); ++row) {
      systems.presence[row * lanes + lane] = 1;
      if (smoothing.size() > 0) systems.smoothing[row * lanes + lane] = smoothing[column[row]] / unit;
      for (std::size_t axis = 0; axis < dimension; ++axis)
        systems.coordinates[(row * dimension + axis) * lanes + lane] =
            (points(static_cast<Eigen::Index>(axis), column[row]) - own[static_cast<Eigen::Index>(axis)]) / reach;
    }
  }
  return factors;
}

/// Puts the points that determine the polynomials in place of the farthest predecessors.
void anchor(Column& column, const std::vector<std::uint32_t>& first) {
  std::size_t place = column.size();
  for (const std::uint32_t point : first) {
    if (std::find(column.begin(), column.end(), point) != column.end()) continue;
    while (place > 1 && std::find(first.begin(), first.end(), column[place - 1]) != first.end()) --place;
    if (place > 1) column[--place] = point;
  }
}

}  // namespace

SparseFactor::SparseFactor(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& smoothing,
                           const std::vector<std::uint32_t>& first, const CoarseToFineOptions& options,
                           const Progress& progress) {
  double start = seconds_now();
  CoarseToFine order = order_coarse_to_fine(points, first, options, progress);
  order_seconds = seconds_now() - start;
  start = seconds_now();

  const auto count = static_cast<std::size_t>(points.cols());
  begin_.assign(count + 1, 0);
  for (const CoarseToFine::Level& level : order.levels)
    for (std::size_t q = 0; q < level.points.size(); ++q)
      begin_[level.points[q] + 1] = level.begin[q + 1] - level.begin[q] + 1;
  for (std::size_t i = 0; i < count; ++i) begin_[i + 1] += begin_[i];
  indices_.resize(begin_.back());
  values_.resize(begin_.back());
  std::size_t done = first.size();
  for (CoarseToFine::Level& level : order.levels) {
    fill_level(kernel, points, smoothing, first, level);
    done += level.points.size();
    progress.report("precondition", static_cast<double>(done) / static_cast<double>(count));
    level = {};
  }
  factor_seconds = seconds_now() - start;
}

void SparseFactor::fill_level(const Kernel& kernel, const Eigen::MatrixXd& points, const Eigen::VectorXd& smoothing,
                              const std::vector<std::uint32_t>& first, const CoarseToFine::Level& level) {
  const Eigen::MatrixXi exponents = monomial_exponents(static_cast<int>(points.rows()), kernel.tail_degree);
  const auto monomials = static_cast<std::size_t>(exponents.cols());
  std::atomic<std::size_t> repaired = 0;
  const auto column_of = [&](std::size_t q) {
    Column column{level.points[q]};
    column.insert(column.end(), level.predecessors.begin() + static_cast<std::ptrdiff_t>(level.begin[q]),
                  level.predecessors.begin() + static_cast<std::ptrdiff_t>(level.begin[q + 1]));
    return column;
  };
  const auto write = [&](const Column& column, const LocalSystems& systems, std::size_t lane, double factor) {
    const std::uint64_t begin = begin_[column[0]];
    for (std::size_t row = 0; row < column.size(); ++row) {
      indices_[begin + row] = column[row];
      values_[begin + row] = factor * systems.columns[row * lanes + lane];
    }
  };
  tbb::parallel_for(std::size_t{0}, (level.points.size() + lanes - 1) / lanes, [&](std::size_t batch) {
    thread_local LocalSystems systems, single;
    std::vector<Column> columns;
    for (std::size_t q = batch * lanes; q < std::min(level.points.size(), (batch + 1) * lanes); ++q)
      columns.push_back(column_of(q));
    const auto factors = load_columns(kernel, points, smoothing, columns, monomials, systems);
    solve_local_systems(kernel, exponents, systems);
    for (std::size_t lane = 0; lane < columns.size(); ++lane) {
      if (systems.solved[lane]) {
        write(columns[lane], systems, lane, factors[lane]);
        continue;
      }
      ++repaired;
      Column column = columns[lane];
      anchor(column, first);
      auto factor = load_columns(kernel, points, smoothing, {column}, monomials, single);
      solve_local_systems(kernel, exponents, single);
      if (!single.solved[0]) {  // the point and those that determine the polynomials: one number to find
        Column least{column[0]};
        least.insert(least.end(), first.begin(), first.end());
        factor = load_columns(kernel, points, smoothing, {least}, monomials, single);
        solve_local_systems(kernel, exponents, single);
        for (const std::uint32_t j : column)  // keeps the column's length
          if (least.size() < column.size() && std::find(least.begin(), least.end(), j) == least.end())
            least.push_back(j);
        single.columns.resize(std::max(single.columns.size(), least.size() * lanes), 0.0);
        column = least;
      }
      write(column, single, 0, factor[0]);
    }
  });
  repaired_ += repaired;
}

/// Uᵀ r: one sum per column.
Eigen::VectorXd SparseFactor::transposed_times(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd result(residual.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, begin_.size() - 1, 512), [&](const auto& range) {
    for (std::size_t column = range.begin(); column < range.end(); ++column) {
      double sum = 0;
      for (std::uint64_t k = begin_[column]; k < begin_[column + 1]; ++k) sum += values_[k] * residual[indices_[k]];
      result[static_cast<Eigen::Index>(column)] = sum;
    }
  });
  return result;
}

/// U v: every part of the columns is spread over a vector of its own, since a second copy of U by rows
/// would double the memory. The number of parts is fixed, so that the order of additions is.
Eigen::VectorXd SparseFactor::times(const Eigen::VectorXd& v) const {
  constexpr std::size_t parts = 8;
  const std::size_t count = begin_.size() - 1;
  std::array<Eigen::VectorXd, parts> sums;
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
    sums[part] = Eigen::VectorXd::Zero(v.size());
    double* sum = sums[part].data();
    for (std::size_t column = count * part / parts; column < count * (part + 1) / parts; ++column) {
      const double factor = v[static_cast<Eigen::Index>(column)];
      for (std::uint64_t k = begin_[column]; k < begin_[column + 1]; ++k) sum[indices_[k]] += factor * values_[k];
    }
  });
  Eigen::VectorXd result = std::move(sums[0]);
  tbb::parallel_for(tbb::blocked_range<Eigen::Index>(0, v.size(), 4096), [&](const auto& range) {
    const Eigen::Index length = static_cast<Eigen::Index>(range.size());
    for (std::size_t part = 1; part < parts; ++part)
      result.segment(range.begin(), length) += sums[part].segment(range.begin(), length);
  });
  return result;
}

Eigen::VectorXd SparseFactor::apply(const Eigen::VectorXd& residual) const { return times(transposed_times(residual)); }

std::size_t SparseFactor::bytes() const {
  return indices_.size() * (sizeof(std::uint32_t) + sizeof(double)) + begin_.size() * sizeof(std::uint64_t);
}

}  // namespace isostack
