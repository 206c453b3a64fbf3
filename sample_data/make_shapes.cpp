// isostack_make_shapes OUT_DIR: writes the shapes to morph: plane figures as PNG, bodies as PLY, and landmarks. Same
// bytes on every run.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "io/atomic_file.h"
#include "io/images/write_pictures.h"
#include "io/meshes/write_mesh.h"
#include "recon/surface/extract_surface.h"
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

ScalarField field_of(const Body& body) {
  ScalarField field;
  field.values = [&body](const Eigen::Matrix3Xd& points) {
    Eigen::VectorXd values(points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) values[i] = body.depth_mm(points.col(i));
    return values;
  };
  field.gradients = [&body](const Eigen::Matrix3Xd& points) {
    constexpr double step_mm = 1e-4;
    Eigen::Matrix3Xd gradients(3, points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d step = step_mm * Eigen::Vector3d::Unit(axis), point = points.col(i);
        gradients(axis, i) = (body.depth_mm(point + step) - body.depth_mm(point - step)) / (2 * step_mm);
      }
    return gradients;
  };
  return field;
}

/// A place on the surface, found on a line from far outside to the middle of the body or through it.
Eigen::Vector3d seed_of(const Body& body) {
  Eigen::Vector3d point(bounds_mm, 0.3, 0.2);
  while (body.depth_mm(point) < 0) point.x() -= 0.05;
  return point;
}

TriangleMesh mesh_of(const Body& body) {
  ExtractionOptions options;
  options.resolution_mm = cell_mm;
  options.bounds = Eigen::AlignedBox3d(Eigen::Vector3d::Constant(-bounds_mm), Eigen::Vector3d::Constant(bounds_mm));
  TriangleMesh mesh = extract_surface(field_of(body), {seed_of(body)}, options).mesh;
  mesh.name = body.name;
  return mesh;
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

void make_shapes(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const PlaneFigure& figure : plane_figures()) write_png(image_of(figure), folder / (figure.name + ".png"));
  for (const Body& body : bodies()) write_mesh(mesh_of(body), folder / (body.name + ".ply"));
  write_whole_file(folder / "x_to_o_turned.json", turning_landmarks);
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
