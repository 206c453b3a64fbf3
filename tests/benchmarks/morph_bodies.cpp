// morph_bodies [--kernel NAME] [--spacing S] [--recipe paper] [--frames N] [--cells N] [--constraints N] [-o DIR] A B
// [C...] A variational morph between bodies: time and memory of the solve and of the frames, and how well the frames at
// the key shapes equal them. Shapes: a mesh file, or sphere, torus, star, knot (generated). Files are scaled to 100 mm
// and centred, open rims closed by fans to their centroids; with --in-place they stay as they are. Two shapes, or more
// with --line, lie along t; three or more otherwise at the corners of a simplex, where every edge of it gets N frames.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>

#include "io/meshes/read_mesh.h"
#include "io/meshes/write_mesh.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "recon/morphing/variational_morph.h"
#include "tests/support/fan_closed.h"
#include "tests/support/morph_meshes.h"

namespace isostack::benchmarks {
namespace {

struct Job {
  std::vector<std::string> names;
  std::string kernel = "triharmonic", recipe = "signed-distance", directory;
  std::size_t constraints = 20'000, frames = 16;
  double spacing = 0.25;  ///< in longest sides of the box
  int cells = 100;        ///< along it
  bool in_place = false, on_line = false;
};

Eigen::AlignedBox3d box_round(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) box.extend(v);
  return box;
}

TriangleMesh shape_named(const std::string& name, bool in_place) {
  using namespace testing_support;  // NOLINT(google-build-using-namespace): four generators of it
  if (name == "sphere") return sphere_mesh(Eigen::Vector3d::Zero(), 40, 160, 80);
  if (name == "torus") return torus_mesh(36, 14, 200, 80);
  if (name == "star") return star_mesh(50, 240, 120);
  if (name == "knot") return knot_mesh(42, 8, 400, 50);
  TriangleMesh mesh = fan_closed(read_mesh(name));
  if (in_place) return mesh;
  const Eigen::AlignedBox3d box = box_round(mesh);
  for (Eigen::Vector3d& v : mesh.vertices_mm) v = 100 / box.sizes().maxCoeff() * (v - box.center());
  return mesh;
}

/// The places of the frames: along the line, or round the simplex.
std::vector<Eigen::VectorXd> places(const Morph& morph, std::size_t frames) {
  std::vector<Eigen::VectorXd> result;
  const Eigen::Index keys = morph.places().key_count();
  if (morph.places().layout == KeyLayout::line) {
    for (std::size_t i = 0; i < frames; ++i)
      result.push_back(morph.places().weights_at(static_cast<double>(i) / static_cast<double>(frames - 1)));
    return result;
  }
  std::vector<Eigen::VectorXd> corners;
  for (Eigen::Index k = 0; k <= keys; ++k) corners.push_back(Eigen::VectorXd::Unit(keys, k % keys));
  return weights_along_path(corners, frames * static_cast<std::size_t>(keys) + 1);
}

void print_frame(const Eigen::VectorXd& weights, const TriangleMesh& frame, const std::vector<TriangleMesh>& given,
                 double seconds) {
  const MeshMeasures measures = measure(frame);
  std::string at;
  for (const double weight : weights) at += fmt::format("{:.3f} ", weight);
  fmt::print("frame {}seconds {:.2f} vertices {} volume_mm3 {:.0f} components {} genus {} {}", at, seconds,
             measures.vertices, measures.volume_mm3, measures.components, measures.genus,
             measures.watertight() ? "closed" : "NOT CLOSED");
  Eigen::Index key = 0;
  if (weights.maxCoeff(&key) > 1 - 1e-9) {
    const TriangleMesh& shape = given[static_cast<std::size_t>(key)];
    const double diagonal_mm = box_round(shape).diagonal().norm();
    const SurfaceDistance distance = surface_distance(frame, shape);
    fmt::print(" mean_percent_of_diagonal {:.4f} largest {:.3f} volume_percent {:+.3f}",
               100 * distance.mean_mm / diagonal_mm, 100 * distance.largest_mm / diagonal_mm,
               100 * (measures.volume_mm3 / measure(shape).volume_mm3 - 1));
  }
  fmt::print("\n");
}

void run(const Job& job) {
  std::vector<TriangleMesh> given;
  std::vector<KeyShape> keys;
  Eigen::AlignedBox3d box;
  for (const std::string& name : job.names) {
    given.push_back(shape_named(name, job.in_place));
    keys.push_back({.name = name, .shape = given.back()});
    box.extend(box_round(given.back()));
  }
  const double side_mm = box.sizes().maxCoeff();
  VariationalMorphOptions options;
  options.kernel = kernel_named(job.kernel);
  if (job.recipe == "paper") options.recipe = MorphRecipe::turk_obrien;
  if (keys.size() > 2 && !job.on_line) options.layout = KeyLayout::simplex;
  options.spacing_mm = job.spacing * side_mm;
  options.max_constraints = job.constraints;
  options.resolution_mm = side_mm / job.cells;
  const Stopwatch whole;
  const Morph morph = variational_morph(keys, options);
  const MorphReport& report = morph.report();
  fmt::print("constraints {}\nconstraint_seconds {:.2f}\nsolve_seconds {:.2f}\nsolver {}\niterations {}\n",
             report.constraints, report.constraint_seconds, report.solve_seconds, report.solve.solver,
             report.solve.iterations);
  fmt::print("residual_mm {:.1e}\nsolve_peak_gb {:.2f}\n", report.solve.largest_residual,
             static_cast<double>(peak_memory_bytes()) / 1e9);
  double frame_seconds = 0, measured_seconds = 0;
  int number = 0;
  for (const Eigen::VectorXd& weights : places(morph, job.frames)) {
    const Stopwatch watch;
    const TriangleMesh frame = std::get<TriangleMesh>(morph.at(weights));
    frame_seconds += watch.seconds();
    const Stopwatch measuring;
    print_frame(weights, frame, given, watch.seconds());
    if (!job.directory.empty())
      write_mesh(frame, std::filesystem::path(job.directory) / fmt::format("frame_{:03d}.ply", number++));
    measured_seconds += measuring.seconds();
  }
  fmt::print("frame_seconds {:.2f}\nseconds {:.2f}\npeak_gb {:.2f}\n", frame_seconds,
             whole.seconds() - measured_seconds, static_cast<double>(peak_memory_bytes()) / 1e9);
}

}  // namespace
}  // namespace isostack::benchmarks

int main(int argc, char** argv) {
  isostack::benchmarks::Job job;
  CLI::App app("Variational morphs between bodies, measured.");
  app.add_option("shapes", job.names, "mesh files, sphere, torus, star, knot")->required();
  app.add_option("--kernel", job.kernel);
  app.add_option("--recipe", job.recipe, "signed-distance or paper");
  app.add_option("--spacing", job.spacing, "of the key shapes, in longest sides of the box");
  app.add_option("--frames", job.frames, "along the line or each edge");
  app.add_option("--cells", job.cells, "along the longest side of the box");
  app.add_option("--constraints", job.constraints, "at most");
  app.add_flag("--in-place", job.in_place);
  app.add_flag("--line", job.on_line);
  app.add_option("-o", job.directory, "folder for the frames");
  CLI11_PARSE(app, argc, argv);
  try {
    isostack::benchmarks::run(job);
    return 0;
  } catch (const isostack::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
}
