#include "recon/solvers/sparse_factor.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
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
  columns_.begin.assign(count + 1, 0);
  for (const CoarseToFine::Level& level : order.levels)
    for (std::size_t q = 0; q < level.points.size(); ++q)
      columns_.begin[level.points[q] + 1] = level.begin[q + 1] - level.begin[q] + 1;
  for (std::size_t i = 0; i < count; ++i) columns_.begin[i + 1] += columns_.begin[i];
  columns_.indices.resize(columns_.begin.back());
  columns_.values.resize(columns_.begin.back());
  std::size_t done = first.size();
  for (CoarseToFine::Level& level : order.levels) {
    fill_level(kernel, points, smoothing, first, level);
    done += level.points.size();
    progress.report("precondition", static_cast<double>(done) / static_cast<double>(count));
    level = {};
  }
  factor_seconds = seconds_now() - start;
  start = seconds_now();
  transpose();
  transpose_seconds = seconds_now() - start;
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
    const std::uint64_t begin = columns_.begin[column[0]];
    for (std::size_t row = 0; row < column.size(); ++row) {
      columns_.indices[begin + row] = column[row];
      columns_.values[begin + row] = factor * systems.columns[row * lanes + lane];
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

void SparseFactor::transpose() {
  constexpr std::size_t parts = 16;  // fixed, so that the order of a row's entries is
  const std::size_t count = columns_.begin.size() - 1;
  const auto part_begin = [&](std::size_t part) { return count * part / parts; };
  std::vector<std::vector<std::uint32_t>> counts(parts, std::vector<std::uint32_t>(count, 0));
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
    for (std::uint64_t k = columns_.begin[part_begin(part)]; k < columns_.begin[part_begin(part + 1)]; ++k)
      ++counts[part][columns_.indices[k]];
  });
  rows_.begin.assign(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t total = 0;
    for (std::size_t part = 0; part < parts; ++part) {
      const std::uint32_t here = counts[part][i];
      counts[part][i] = total;
      total += here;
    }
    rows_.begin[i + 1] = rows_.begin[i] + total;
  }
  rows_.indices.resize(columns_.indices.size());
  rows_.values.resize(columns_.values.size());
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
    for (std::size_t c = part_begin(part); c < part_begin(part + 1); ++c)
      for (std::uint64_t k = columns_.begin[c]; k < columns_.begin[c + 1]; ++k) {
        const std::uint32_t row = columns_.indices[k];
        const std::uint64_t place = rows_.begin[row] + counts[part][row]++;
        rows_.indices[place] = static_cast<std::uint32_t>(c);
        rows_.values[place] = columns_.values[k];
      }
  });
}

Eigen::VectorXd SparseFactor::Compressed::times(const Eigen::VectorXd& v) const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(begin.size()) - 1);
  tbb::parallel_for(tbb::blocked_range<Eigen::Index>(0, result.size(), 512), [&](const auto& range) {
    for (Eigen::Index i = range.begin(); i < range.end(); ++i) {
      double sum = 0;
      for (std::uint64_t k = begin[static_cast<std::size_t>(i)]; k < begin[static_cast<std::size_t>(i) + 1]; ++k)
        sum += values[k] * v[indices[k]];
      result[i] = sum;
    }
  });
  return result;
}

Eigen::VectorXd SparseFactor::apply(const Eigen::VectorXd& residual) const {
  return rows_.times(columns_.times(residual));
}

std::size_t SparseFactor::bytes() const {
  return 2 * (columns_.indices.size() * (sizeof(std::uint32_t) + sizeof(double)) + columns_.begin.size() * 8);
}

}  // namespace isostack
