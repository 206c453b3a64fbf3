// distance_volumes MESH.obj: how long mesh_distance takes, by voxels and by faces. Rival: rival_vtk_distance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/distance/mesh_distance.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/stopwatch.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/obj_mesh.h"

namespace {

using namespace isostack;

/// As rival_vtk_distance has it: the mesh's longest side takes n - 9 voxels.
Grid grid_round(const TriangleMesh& mesh, int n) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) box.extend(v);
  Grid grid;
  grid.size.setConstant(n);
  grid.index_to_world.linear() *= box.sizes().maxCoeff() / (n - 9);
  grid.index_to_world.translation() =
      box.center() - grid.index_to_world.linear() * Eigen::Vector3d::Constant(0.5 * (n - 1));
  return grid;
}

void run(const TriangleMesh& mesh, int n, DistanceExtent extent) {
  const Grid grid = grid_round(mesh, n);
  MeshDistanceOptions options;
  options.extent = extent;
  const double band_mm = 3 * grid.index_to_world.linear()(0, 0);
  double seconds = 1e30;
  std::ptrdiff_t in_band = 0;
  for (int repeat = 0; repeat < 3; ++repeat) {
    const Stopwatch watch;
    const MeshDistance found = mesh_distance(mesh, grid, options);
    seconds = std::min(seconds, watch.seconds());
    in_band = std::count_if(found.distance_mm.voxels.begin(), found.distance_mm.voxels.end(),
                            [&](float mm) { return std::abs(static_cast<double>(mm)) < band_mm * (1 - 1e-6); });
  }
  fmt::print("{:>9} faces {:>4}^3 {} {:>9} in the band {:.3f} s\n", mesh.triangles.size(), n,
             extent == DistanceExtent::band ? "band" : "full", in_band, seconds);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: distance_volumes MESH.obj\n");
    return 2;
  }
  try {
    const TriangleMesh mesh = testing_support::obj_mesh(argv[1]);
    for (const int n : {64, 128, 256}) run(mesh, n, DistanceExtent::band);
    for (const int n : {64, 128}) run(mesh, n, DistanceExtent::full);
    for (const int around : {32, 57, 101, 180, 255, 320, 569, 1000})
      run(testing_support::torus_mesh(20, 8, around, around / 2), 128, DistanceExtent::band);
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 3;
  }
}
