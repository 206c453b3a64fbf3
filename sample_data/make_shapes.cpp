// isostack_make_shapes OUT_DIR: writes the shapes to morph: plane figures as PNG and contours, bodies as PLY, landmarks
// and features. Same bytes on every run.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "io/atomic_file.h"
#include "io/contours/contour_files.h"
#include "io/images/write_pictures.h"
#include "io/meshes/write_mesh.h"
#include "sample_data/body_mesh.h"
#include "sample_data/outlines.h"
#include "sample_data/shapes.h"

namespace {

using namespace isostack;

constexpr int pixels = 96;  ///< of 1 mm, each way
constexpr double cell_mm = 1.5, bounds_mm = 60;

/// White where the figure is; a pixel on its edge is as bright as the edge's distance says.
Image<std::uint8_t> image_of(const PlaneFigure& figure) {
  Image<std::uint8_t> image(pixels, pixels);
  for (int row = 0; row < pixels; ++row)
    for (int column = 0; column < pixels; ++column) {
      const double covered = std::clamp(0.5 + figure.distance_mm(Eigen::Vector2d(column, row)), 0.0, 1.0);
      image(row, column) = static_cast<std::uint8_t>(std::lround(255 * covered));
    }
  return image;
}

TriangleMesh mesh_of(const Body& body) {
  const Eigen::AlignedBox3d bounds(Eigen::Vector3d::Constant(-bounds_mm), Eigen::Vector3d::Constant(bounds_mm));
  return isostack::mesh_of(body, bounds, cell_mm);
}

/// The ends of the x's arms go to places of the o an eighth of a turn farther on.
constexpr const char* turning_landmarks = R"({
  "format": "isostack-landmarks",
  "version": 1,
  "landmarks": [
    {"name": "right, below", "from_mm": [76.5, 76.5, 0], "to_mm": [47.5, 85.5, 0]},
    {"name": "left, below", "from_mm": [18.5, 76.5, 0], "to_mm": [9.5, 47.5, 0]},
    {"name": "left, above", "from_mm": [18.5, 18.5, 0], "to_mm": [47.5, 9.5, 0]},
    {"name": "right, above", "from_mm": [76.5, 18.5, 0], "to_mm": [85.5, 47.5, 0]}
  ]
}
)";

/// The star's arms become the triangle's lower corners, its legs points between these.
constexpr const char* star_features = R"({
  "format": "isostack-features",
  "version": 1,
  "features": [
    {"from": {"shape": 0, "place_mm": [48, 10]}, "to": {"shape": 1, "place_mm": [48, 12]}},
    {"from": {"shape": 0, "place_mm": [86.04, 37.64]}, "to": {"shape": 1, "place_mm": [84, 78]}},
    {"from": {"shape": 0, "place_mm": [71.51, 82.36]}, "to": {"shape": 1, "place_mm": [59, 78]}},
    {"from": {"shape": 0, "place_mm": [24.49, 82.36]}, "to": {"shape": 1, "place_mm": [37, 78]}},
    {"from": {"shape": 0, "place_mm": [9.96, 37.64]}, "to": {"shape": 1, "place_mm": [12, 78]}}
  ]
}
)";

/// The middle bar of the 3 comes out too far on the way from the 2.
std::string bar_transition(int level) {
  return R"({
  "format": "isostack-features",
  "version": 1,
  "transitions": [{"level": )" +
         std::to_string(level) + R"(, "t": 0.5, "place_mm": [40, 52], "to_mm": [20, 46]}]
}
)";
}

/// As large as the modelled head, its corners right, left, behind, before, above and below.
TriangleMesh octahedron() {
  TriangleMesh mesh{.name = "octahedron", .vertices_mm = {}, .triangles = {}, .normals = {}};
  mesh.vertices_mm = {{110, 0, 50}, {-110, 0, 50}, {0, 110, 50}, {0, -110, 50}, {0, 0, 170}, {0, 0, -70}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

/// The corner before becomes the modelled head's nose, drawn out on the way.
constexpr const char* nose_feature = R"({
  "format": "isostack-features",
  "version": 1,
  "features": [
    {"from": {"shape": 0, "vertex": 3}, "to": {"shape": 1, "place_mm": [0, -112, 54]},
     "by_way_of": [{"t": 0.5, "place_mm": [0, -150, 40]}]}
  ]
}
)";

void make_shapes(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const PlaneFigure& figure : plane_figures()) write_png(image_of(figure), folder / (figure.name + ".png"));
  for (const Body& body : bodies()) write_mesh(mesh_of(body), folder / (body.name + ".ply"));
  for (const ContourSlice& figure : outline_figures())
    write_contours({{.name = figure.name, .slices = {figure}}}, folder / (figure.name + ".json"));
  write_mesh(octahedron(), folder / "octahedron.ply");
  write_whole_file(folder / "octahedron_to_nose.json", nose_feature);
  write_whole_file(folder / "x_to_o_turned.json", turning_landmarks);
  write_whole_file(folder / "pointed_to_triangle.json", star_features);
  for (const int level : {1, 2, 3})
    write_whole_file(folder / ("bar_at_level_" + std::to_string(level) + ".json"), bar_transition(level));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || std::string(argv[1]).starts_with("-")) {
    std::fputs("usage: isostack_make_shapes OUT_DIR\n", stderr);
    return 2;
  }
  try {
    make_shapes(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
  return 0;
}
