// isostack_make_key_shapes OUT_DIR: writes the shapes of two papers' figures: heads as a polygonal mesh, a constructive
// solid and a CT (Breen et al. 2001, Figure 1), and discs, a cross, a cube and two tori (Pasko, Pasko & Kunii 2004,
// Figures 4, 7 and 9). Same bytes on every run.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>

#include "io/atomic_file.h"
#include "io/contours/contour_files.h"
#include "io/meshes/write_mesh.h"
#include "io/volumes/volume_files.h"
#include "sample_data/body_mesh.h"
#include "sample_data/heads.h"

namespace {

using namespace isostack;
using Eigen::Vector2d;
using Eigen::Vector3d;

Contour circle(const Vector2d& centre_mm, double radius_mm) {
  constexpr int sides = 240;
  Contour contour;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    contour.points_mm.push_back(centre_mm + radius_mm * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return contour;
}

/// Two bars about (50, 50).
Contour cross() {
  constexpr double length = 43, width = 12;
  Contour contour;
  for (int quarter = 0; quarter < 4; ++quarter)
    for (const Vector2d& corner : {Vector2d(length, -width), Vector2d(length, width), Vector2d(width, width)}) {
      Vector2d turned = corner;
      for (int i = 0; i < quarter; ++i) turned = Vector2d(-turned.y(), turned.x());
      contour.points_mm.push_back(Vector2d(50, 50) + turned);
    }
  return contour;
}

void write_figure(const std::string& name, std::vector<Contour> contours, const std::filesystem::path& path) {
  ContourSlice slice;
  slice.name = name;
  slice.contours = std::move(contours);
  write_contours({{.name = name, .slices = {slice}}}, path);
}

TriangleMesh cube() {
  TriangleMesh mesh;
  mesh.name = "cube";
  for (int c = 0; c < 8; ++c) mesh.vertices_mm.emplace_back(c & 1 ? 28 : -28, c & 2 ? 28 : -28, c & 4 ? 28 : -28);
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

/// Rings of 30 mm about (100, 0, 0), across z and across y.
double tori_depth(const Vector3d& point) {
  double depth = -1e9;
  for (const int axis : {2, 1}) {
    Vector3d p = point - Vector3d(100, 0, 0);
    const double along = std::exchange(p[axis], 0);
    depth = std::max(depth, 8 - std::hypot(p.norm() - 30, along));
  }
  return depth;
}

void make_key_shapes(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_mesh(mesh_of(modelled_head(), {Vector3d(-100, -130, -90), Vector3d(100, 130, 190)}, 4), folder / "head.ply");
  write_whole_file(folder / "head_solid.json", solid_head_json());
  write_volume(stored_volume_of(scanned_head()), folder / "head_scan.mha");
  write_figure("discs", {circle({27, 50}, 20), circle({73, 50}, 20)}, folder / "discs.json");
  write_figure("cross", {cross()}, folder / "cross.json");
  write_mesh(cube(), folder / "cube.ply");
  write_mesh(mesh_of({"tori", 0, tori_depth}, {Vector3d(50, -50, -50), Vector3d(150, 50, 50)}, 1.5),
             folder / "tori.ply");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || std::string(argv[1]).starts_with("-")) {
    std::fputs("usage: isostack_make_key_shapes OUT_DIR\n", stderr);
    return 2;
  }
  try {
    make_key_shapes(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
  return 0;
}
