// distance_to_star_stack MESH SLICES: how far a rival's surface is from the contour points it was made from.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "io/meshes/read_mesh.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "tests/benchmarks/star_stack.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: distance_to_star_stack MESH SLICES\n");
    return 2;
  }
  try {
    using namespace isostack;
    const TriangleMesh mesh = read_mesh(argv[1]);
    const benchmarks::OrientedPoints contours = benchmarks::oriented_points(benchmarks::star_stack(std::atoi(argv[2])));
    std::vector<Eigen::Vector3d> points;
    for (Eigen::Index i = 0; i < contours.points.cols(); ++i) points.emplace_back(contours.points.col(i));
    const std::vector<double> distances = distances_to_mesh_mm(points, mesh);
    fmt::print(
        "remark {} contour points; {} vertices, {}; contour points at most {:.3f} mm from it, {:.3f} on average\n",
        points.size(), mesh.vertices_mm.size(), measure(mesh).watertight() ? "closed" : "not closed",
        *std::max_element(distances.begin(), distances.end()),
        std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size()));
    return 0;
  } catch (const isostack::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 3;
  }
}
