// surface_star_stack SLICES RESOLUTION_MM: contours to surface: the solve (kernel r, residual 1e-3) and the extraction,
// and how far the surface is from the contour points.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/implicit_function.h"
#include "tests/benchmarks/measured_solve.h"
#include "tests/benchmarks/star_stack.h"

namespace isostack::benchmarks {
namespace {

/// The contours' box, wider by 20 mm within the slices and cut half a gap beyond the outermost ones.
Eigen::AlignedBox3d bounds(const StarStack& stack) {
  const Eigen::Vector3d margin(20, 20, star_slice_gap_mm / 2);
  return {stack.points.rowwise().minCoeff() - margin, stack.points.rowwise().maxCoeff() + margin};
}

int run(int slices, double resolution_mm) {
  constexpr double tolerance = 1e-3;
  const Kernel kernel = biharmonic();
  const StarStack stack = star_stack(slices);
  const MeasuredSolve solve = measured_solve(kernel, stack.points, stack.values, tolerance);

  const Stopwatch watch;
  const ImplicitFunction function(kernel, stack.points, solve.solution.function, tolerance);
  const ScalarField field{
      [&](const Eigen::Matrix3Xd& points) { return function.values(points); },
      [&](const Eigen::Matrix3Xd& points) -> Eigen::Matrix3Xd { return function.gradients(points); }};
  const OrientedPoints contours = oriented_points(stack);
  std::vector<Eigen::Vector3d> seeds;
  for (Eigen::Index i = 0; i < contours.points.cols(); ++i) seeds.emplace_back(contours.points.col(i));
  ExtractionOptions options;
  options.resolution_mm = resolution_mm;
  options.bounds = bounds(stack);
  const ExtractedSurface surface = extract_surface(field, seeds, options);
  const double surface_seconds = watch.seconds();

  fmt::print("constraints {}\nseconds {:.2f}\niterations {}\npeak_gb {:.2f}\n", stack.values.size(),
             solve.seconds + surface_seconds, solve.solution.iterations,
             static_cast<double>(peak_memory_bytes()) / 1e9);
  fmt::print("residual {:.1e}\n", largest_residual(kernel, stack.points, stack.values, solve.solution.function));
  const std::vector<double> distances = distances_to_mesh_mm(seeds, surface.mesh);
  fmt::print(
      "remark {} contour points; solve {:.2f} s, surface {:.2f} s = {:.2f} of it; {} vertices, {}; contour points at "
      "most {:.3f} mm from it\n",
      seeds.size(), solve.seconds, surface_seconds, surface_seconds / solve.seconds, surface.mesh.vertices_mm.size(),
      measure(surface.mesh).watertight() ? "closed" : "not closed",
      *std::max_element(distances.begin(), distances.end()));
  return 0;
}

}  // namespace
}  // namespace isostack::benchmarks

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: surface_star_stack SLICES RESOLUTION_MM\n");
    return 2;
  }
  try {
    return isostack::benchmarks::run(std::atoi(argv[1]), std::atof(argv[2]));
  } catch (const isostack::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
}
