// random_planes MESH PLANES SEED [KERNEL]: a known surface is cut by random planes, rebuilt from the contours, and
// compared with the original: symmetric Hausdorff distance over the bounding box's diagonal, 25,000 samples each way.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "io/contours/contour_files.h"
#include "io/meshes/read_mesh.h"
#include "io/meshes/write_mesh.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "recon/reconstruct.h"
#include "recon/surface/plane_section.h"

namespace isostack::benchmarks {
namespace {

/// An image of 256 pixels along the diagonal of the mesh's box, centred where the plane is nearest to the box's centre.
ContourSlice slice_through(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box, const Eigen::Vector3d& point,
                           const Eigen::Vector3d& normal, int number) {
  constexpr int pixels = 257;
  const double side = box.diagonal().norm();
  ContourSlice slice;
  slice.name = fmt::format("plane {}", number);
  slice.size_pixels = {pixels, pixels};
  slice.pose.spacing_mm.setConstant(side / (pixels - 1));
  slice.pose.x_axis = normal.unitOrthogonal();
  slice.pose.y_axis = normal.cross(slice.pose.x_axis);
  const Eigen::Vector3d centre = box.center() + normal * normal.dot(point - box.center());
  slice.pose.origin_mm = centre - side / 2 * (slice.pose.x_axis + slice.pose.y_axis);
  slice.contours = plane_section(mesh, slice.pose);
  return slice;
}

ContourStack random_sections(const TriangleMesh& mesh, int planes, unsigned seed) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) box.extend(v);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  ContourStack stack;
  stack.name = mesh.name;
  while (static_cast<int>(stack.slices.size()) < planes) {
    Eigen::Vector3d direction, fraction;
    for (double& d : direction) d = normal(random);
    for (double& u : fraction) u = uniform(random);
    ContourSlice slice = slice_through(mesh, box, box.min() + fraction.cwiseProduct(box.sizes()),
                                       direction.normalized(), static_cast<int>(stack.slices.size()) + 1);
    if (!slice.contours.empty()) stack.slices.push_back(std::move(slice));
  }
  return stack;
}

int run(const char* file, int planes, unsigned seed, const char* kernel, const char* output) {
  const TriangleMesh truth = read_mesh(file);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : truth.vertices_mm) box.extend(v);
  ReconstructOptions options;
  options.kernel = kernel_named(kernel);
  const ContourStack sections = random_sections(truth, planes, seed);
  if (output) write_contours({sections}, std::filesystem::path(output).replace_extension(".json"));
  const Reconstruction result = reconstruct(sections, options);
  const SurfaceDistance distance = surface_distance(result.surface, truth);
  const MeshMeasures found = measure(result.surface), given = measure(truth);
  const double diagonal = box.diagonal().norm();
  fmt::print(
      "{} {} planes, seed {}, {}: largest {:.1f}, mean {:.2f}, 95 % {:.2f} thousandths of the diagonal; components {} "
      "({}), genus {} ({}); {} constraints, {} solves, planes wrong {} of {}, {:.1f} s\n",
      truth.name, planes, seed, kernel, 1000 * distance.largest_mm / diagonal, 1000 * distance.mean_mm / diagonal,
      1000 * distance.percentile95_mm / diagonal, found.components, given.components, found.genus, given.genus,
      result.report.constraints, result.report.solves, result.report.plane_points_wrong, result.report.plane_points,
      result.report.solve_seconds);
  if (output) write_mesh(result.surface, output);
  return 0;
}

}  // namespace
}  // namespace isostack::benchmarks

int main(int argc, char** argv) {
  if (argc < 4 || argc > 6) {
    fmt::print(stderr, "usage: random_planes MESH PLANES SEED [KERNEL [OUT]]\n");
    return 2;
  }
  try {
    return isostack::benchmarks::run(argv[1], std::atoi(argv[2]), static_cast<unsigned>(std::atoi(argv[3])),
                                     argc > 4 ? argv[4] : "triharmonic", argc > 5 ? argv[5] : nullptr);
  } catch (const isostack::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
}
