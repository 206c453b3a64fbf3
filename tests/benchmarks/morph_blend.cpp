// morph_blend: the shapes of Pasko, Pasko & Kunii 2004 (two discs and a cross, a cube and two tori that cross)
// and two disjoint discs; how much their bounded space-time blends change from frame to frame, with half-cylinders that
// end flat and smoothed. Files of the shapes: isostack_make_key_shapes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "recon/geometry/stopwatch.h"
#include "recon/metrics/frame_quality.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/morphing/blend_morph.h"
#include "recon/morphing/frame_components.h"
#include "recon/surface/extract_surface.h"
#include "recon/surface/surface_seeds.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/figures.h"

namespace isostack::benchmarks {
namespace {

using testing_support::disc;
using testing_support::figure;

KeyShape two_discs() {
  return figure("discs", 100, [](const Eigen::Vector2d& p) {
    return 20 - std::min((p - Eigen::Vector2d(27, 50)).norm(), (p - Eigen::Vector2d(73, 50)).norm());
  });
}

KeyShape cross() {
  return figure("cross", 100, [](const Eigen::Vector2d& q) {
    const Eigen::Vector2d p = (q - Eigen::Vector2d(50, 50)).cwiseAbs();
    return std::max(std::min(43 - p.x(), 12 - p.y()), std::min(12 - p.x(), 43 - p.y()));
  });
}

/// 12 mm wide, 86 mm long, about (50, 50).
KeyShape bar(int axis) {
  return figure("bar", 100, [axis](const Eigen::Vector2d& q) {
    const Eigen::Vector2d p = (q - Eigen::Vector2d(50, 50)).cwiseAbs();
    return std::min(43 - p[axis], 6 - p[1 - axis]);
  });
}

/// Round a ring of 30 mm about (100, 0, 0) in the plane across an axis.
double torus_mm(const Eigen::Vector3d& point, int axis) {
  Eigen::Vector3d p = point - Eigen::Vector3d(100, 0, 0);
  const double along = std::exchange(p[axis], 0);
  return 8 - std::hypot(p.norm() - 30, along);
}

TriangleMesh two_tori() {
  ScalarField field;
  field.values = [](const Eigen::Matrix3Xd& points) -> Eigen::VectorXd {
    Eigen::VectorXd values(points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      values[i] = std::max(torus_mm(points.col(i), 2), torus_mm(points.col(i), 1));
    return values;
  };
  field.gradients = [values = field.values](const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3Xd gradients(3, points.cols());
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = 1e-3 * Eigen::Vector3d::Unit(axis);
      gradients.row(axis) = (values(points.colwise() + step) - values(points.colwise() - step)) / 2e-3;
    }
    return gradients;
  };
  ExtractionOptions options;
  options.resolution_mm = 1.5;
  options.bounds = {Eigen::Vector3d(50, -50, -50), Eigen::Vector3d(150, 50, 50)};
  return extract_surface(field, surface_seeds(field, options.bounds, 3), options).mesh;
}

void compare(const std::string& name, const std::vector<KeyShape>& shapes, std::size_t count, double resolution_mm) {
  double flat_change = 0;
  for (const HalfCylinderEnds ends : {HalfCylinderEnds::flat, HalfCylinderEnds::smoothed}) {
    const Stopwatch watch;
    BlendMorphOptions options;
    options.ends = ends;
    options.resolution_mm = resolution_mm;
    const std::vector<Shape> frames = blend_morph(shapes, options).frames(count);
    const FrameComponents components = frame_components(frames, shapes);
    std::vector<double> contents;
    for (const Shape& frame : frames)
      contents.push_back(dimension_of(frame) == 2 ? frame_quality(frame).content
                                                  : measure(std::get<TriangleMesh>(frame)).volume_mm3);
    double change = 0;
    for (std::size_t i = 1; i < count; ++i) change = std::max(change, std::abs(contents[i] - contents[i - 1]));
    const auto [least, most] = std::minmax_element(contents.begin(), contents.end());
    fmt::print("{:16} {:8} frames {:3}  largest change {:9.1f}  least {:9.1f}  most {:9.1f}  stray {}  {:.1f} s\n",
               name, ends == HalfCylinderEnds::flat ? "flat" : "smoothed", count, change, *least, *most,
               components.stray.size(), watch.seconds());
    if (ends == HalfCylinderEnds::flat)
      flat_change = change;
    else
      fmt::print("{:16} {:.1f} times smaller\n", "", flat_change / change);
  }
}

}  // namespace
}  // namespace isostack::benchmarks

int main() {
  using namespace isostack;
  using namespace isostack::benchmarks;
  const KeyShape cube{.name = "cube", .shape = testing_support::box_mesh({-28, -28, -28}, {28, 28, 28})};
  const KeyShape tori{.name = "tori", .shape = two_tori()};
  compare("discs to cross", {two_discs(), cross()}, 41, 1);
  compare("disjoint discs", {disc("a", {20, 50}, 15), disc("b", {75, 40}, 20)}, 41, 1);
  compare("X to O", {testing_support::x_figure(), testing_support::o_figure()}, 41, 1);
  compare("thin bars", {bar(0), bar(1)}, 41, 1);
  compare("cube to two tori", {cube, tori}, 41, 5);
  return 0;
}
