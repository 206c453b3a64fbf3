// solve_star_stack KERNEL SLICES TOLERANCE: the fast solver on a synthetic contour stack, in units of LAPACK's
// dsysv for 10,000 constraints (kernel r) on the same threads in the same run.
//   solve_star_stack biharmonic 156 1e-5      238,368 constraints
//   solve_star_stack triharmonic 156 3e-4
//   solve_star_stack biharmonic 626 1e-5      956,528 constraints
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/solvers/fast_solver.h"

extern "C" void dsysv_(const char* uplo, const int* n, const int* columns, double* a, const int* lda, int* pivots,
                       double* b, const int* ldb, double* work, const int* work_size, int* info);

namespace isostack {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double peak_gb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1e6;
}

struct StarStack {
  Eigen::MatrixXd points;
  Eigen::VectorXd values;
};

Eigen::Vector2d star_point(double angle, double z) {
  return (100 + 20 * std::cos(5 * angle + 0.02 * z)) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

/// Contours r = 100 + 20 cos(5θ + 0.02 z), 5 mm apart, points 1 mm apart, each with a partner of value 1 that lies
/// 1 mm inside.
StarStack star_stack(int slices) {
  constexpr int steps = 20'000;
  std::vector<Eigen::Vector3d> points;
  std::vector<double> values;
  for (int k = 0; k < slices; ++k) {
    const double z = 5.0 * k;
    double walked = 1;
    for (int i = 0; i < steps; ++i) {
      const double angle = 2 * std::numbers::pi * i / steps, next = 2 * std::numbers::pi * (i + 1) / steps;
      const Eigen::Vector2d here = star_point(angle, z), along = star_point(next, z) - here;
      if (walked >= 1) {
        const Eigen::Vector2d inwards = Eigen::Vector2d(-along.y(), along.x()).normalized();
        const Eigen::Vector2d inside = here + inwards;
        points.emplace_back(here.x(), here.y(), z);
        points.emplace_back(inside.x(), inside.y(), z);
        values.insert(values.end(), {0.0, 1.0});
        walked -= 1;
      }
      walked += along.norm();
    }
  }
  StarStack stack;
  stack.points = Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, static_cast<Eigen::Index>(points.size()));
  stack.values = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  return stack;
}

/// Seconds LAPACK takes for the saddle-point system of 10,000 constraints with kernel r.
double unit_seconds() {
  constexpr int count = 10'000, size = count + 4, one = 1, work_size = size * 64;
  const StarStack stack = star_stack(7);
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  right.head(count) = stack.values.head(count);
  for (int j = 0; j < count; ++j) {
    for (int i = j; i < count; ++i) system(i, j) = (stack.points.col(i) - stack.points.col(j)).norm() / 100;
    system(count, j) = 1;
    system.block(count + 1, j, 3, 1) = stack.points.col(j) / 100;
  }
  std::vector<int> pivots(size);
  std::vector<double> work(work_size);
  int info = 0;
  const double start = now();
  dsysv_("L", &size, &one, system.data(), &size, pivots.data(), right.data(), &size, work.data(), &work_size, &info);
  return now() - start;
}

int run(const char* kernel_name, int slices, double tolerance) {
  const double unit = unit_seconds();
  const StarStack stack = star_stack(slices);
  FastSolverOptions options;
  options.tolerance = tolerance;
  options.memory_limit_bytes = std::size_t{16} << 30;
  const double start = now();
  FastSolver solver(kernel_named(kernel_name), stack.points, {}, options);
  const Solution solution = solver.solve(stack.values);
  const double seconds = now() - start;
  fmt::print(
      "{} {} constraints: {:.1f} s = {:.2f} units of {:.1f} s, residual {:.1e} by direct sums, {} iterations, "
      "peak with the unit's 0.8 GB {:.2f} GB\n",
      kernel_name, stack.values.size(), seconds, seconds / unit, unit, solution.largest_residual, solution.iterations,
      peak_gb());
  return solution.converged ? 0 : 1;
}

}  // namespace
}  // namespace isostack

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: solve_star_stack KERNEL SLICES TOLERANCE\n");
    return 2;
  }
  try {
    return isostack::run(argv[1], std::atoi(argv[2]), std::atof(argv[3]));
  } catch (const isostack::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
}
