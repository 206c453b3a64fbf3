// morph_subdivision [LEVELS]: a star with twelve points and a head, 5,000 triangles each, blended by an interpolating
// subdivision surface; sixteen frames at levels 3 to LEVELS (4 unless given), and how the time grows with the vertices.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/morphing/subdivision_morph.h"
#include "tests/support/analytic_meshes.h"

namespace isostack::benchmarks {
namespace {

constexpr int meridians = 50, parallels = 51;  // 5,000 triangles

TriangleMesh star() {
  std::vector<Eigen::Vector3d> points;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-std::numbers::phi, std::numbers::phi})
      for (int axis = 0; axis < 3; ++axis) {
        Eigen::Vector3d& p = points.emplace_back(Eigen::Vector3d::Zero());
        p[axis] = a;
        p[(axis + 1) % 3] = b;
        p.normalize();
      }
  TriangleMesh mesh = testing_support::sphere_mesh({0, 0, 0}, 1, meridians, parallels);
  for (Eigen::Vector3d& v : mesh.vertices_mm) {
    double near = 0;
    for (const Eigen::Vector3d& p : points) near = std::max(near, (p.dot(v) - 0.8) / 0.2);
    v *= 20 * (1 + 1.2 * near * near);
  }
  return mesh;
}

TriangleMesh head() {
  TriangleMesh mesh = testing_support::sphere_mesh({0, 0, 0}, 1, meridians, parallels);
  for (Eigen::Vector3d& v : mesh.vertices_mm) {
    const double nose = std::exp(-20 * (v - Eigen::Vector3d(0, -1, 0)).squaredNorm());
    v = Eigen::Vector3d(24 * v.x(), 30 * v.y(), 34 * v.z()) * (1 + 0.3 * nose);
  }
  return mesh;
}

void run(int finest) {
  const std::vector<KeyShape> shapes{{.name = "star", .shape = star()}, {.name = "head", .shape = head()}};
  double first_seconds = 0, first_vertices = 0;
  for (int levels = 3; levels <= finest; ++levels) {
    const Stopwatch watch;
    SubdivisionMorphOptions options;
    options.levels = levels;
    const Morph morph = subdivision_morph(shapes, options);
    const std::vector<Shape> frames = morph.frames(16);
    const double seconds = watch.seconds();
    std::size_t closed = 0;
    for (const Shape& frame : frames) closed += measure(std::get<TriangleMesh>(frame)).watertight() ? 1 : 0;
    const auto vertices = static_cast<double>(morph.report().levels.back().vertices);
    if (levels == 3) {
      first_seconds = seconds;
      first_vertices = vertices;
    }
    fmt::print("level {}: {:8.0f} vertices, {} of 16 frames closed, {:6.1f} s, {:.1f} GB so far", levels, vertices,
               closed, seconds, static_cast<double>(peak_memory_bytes()) / 1e9);
    if (levels > 3)
      fmt::print(", exponent from level 3 {:.2f}",
                 std::log(seconds / first_seconds) / std::log(vertices / first_vertices));
    fmt::print("\n");
  }
}

}  // namespace
}  // namespace isostack::benchmarks

int main(int argc, char** argv) { isostack::benchmarks::run(argc > 1 ? std::atoi(argv[1]) : 4); }
