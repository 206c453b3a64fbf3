// solve_morph POINTS_PER_SURFACE TOLERANCE: the fast solver, r³, on the constraints of a 4D morph between two shapes.
// 12,500 points per surface make 50,000 constraints.
#include <fmt/format.h>

#include <cstdlib>

#include "recon/geometry/errors.h"
#include "tests/benchmarks/measured_solve.h"
#include "tests/benchmarks/morph_shapes.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: solve_morph POINTS_PER_SURFACE TOLERANCE\n");
    return 2;
  }
  try {
    const isostack::benchmarks::MorphConstraints morph = isostack::benchmarks::morph_constraints(std::atoi(argv[1]));
    return isostack::benchmarks::print_solve(isostack::triharmonic(), morph.points, morph.values, std::atof(argv[2]));
  } catch (const isostack::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
}
