// solve_star_stack KERNEL SLICES TOLERANCE [COUNT]: the fast solver on the synthetic contour stack, or on its first
// COUNT constraints. A slice has some 1,530 of them: 31, 156, 313 and 626 slices make 47, 239, 478 and 956 thousand.
#include <fmt/format.h>

#include <cstdlib>

#include "recon/geometry/errors.h"
#include "tests/benchmarks/measured_solve.h"
#include "tests/benchmarks/star_stack.h"

int main(int argc, char** argv) {
  if (argc != 4 && argc != 5) {
    fmt::print(stderr, "usage: solve_star_stack KERNEL SLICES TOLERANCE [COUNT]\n");
    return 2;
  }
  try {
    const isostack::benchmarks::StarStack stack = isostack::benchmarks::star_stack(std::atoi(argv[2]));
    const Eigen::Index count = argc == 5 ? std::atoi(argv[4]) : stack.values.size();
    return isostack::benchmarks::print_solve(isostack::kernel_named(argv[1]), stack.points.leftCols(count),
                                             stack.values.head(count), std::atof(argv[3]));
  } catch (const isostack::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
}
