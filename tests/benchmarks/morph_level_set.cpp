// morph_level_set B.obj [NODES [identity|clamped|tanh]]: a sphere becomes B by a level-set morph with NODES (128) along
// the longest side: time of the distances, of the evolution and of 16 frames, and how the frames compare with B.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"
#include "recon/morphing/level_set_morph.h"
#include "recon/morphing/shape_moments.h"
#include "tests/support/analytic_meshes.h"
#include "tests/support/obj_mesh.h"

namespace isostack::benchmarks {
namespace {

/// About the mesh's centre of mass, as large as it.
TriangleMesh sphere_for(const TriangleMesh& mesh) {
  const ShapeMoments moments = moments_of(mesh, {});
  const double radius_mm = std::cbrt(moments.content * 0.75 / EIGEN_PI);
  return testing_support::sphere_mesh(moments.centre, radius_mm, 160, 80);
}

void measure_morph(const std::string& path, int nodes, ApproachProfile profile) {
  const TriangleMesh target = testing_support::obj_mesh(path);
  const std::vector<KeyShape> shapes{{.name = "sphere", .shape = sphere_for(target)}, {.name = path, .shape = target}};
  LevelSetMorphOptions options;
  options.profile = profile;
  const double margins = 7;  // nodes of the lattice beyond the box
  options.resolution_mm = box_of(shapes).sizes().maxCoeff() / (nodes - margins);
  LevelSetPlan plan = plan_level_set_morph(shapes, options);
  for (const UnsharedPart& part : plan.unshared)
    fmt::print("{} without overlap at {:.3g} {:.3g} {:.3g}: {:.3g} mm³\n", part.is_hollow ? "hollow" : "part",
               part.place_mm.x(), part.place_mm.y(), part.place_mm.z(), part.content);
  const LevelSetMorph result = run_level_set_morph(std::move(plan));
  const LevelSetCourse& course = result.courses.front();
  const Stopwatch watch;
  const std::vector<Shape> frames = result.morph.frames(16);
  const double frame_seconds = watch.seconds();
  const auto falls = std::adjacent_find(course.steps.begin(), course.steps.end(), [](const auto& a, const auto& b) {
    return b.shared_fraction < a.shared_fraction;
  });
  fmt::print("{} steps{}, shared {:.3f} to {:.4f}, {}\n", course.steps.size() - 1,
             course.arrived ? "" : ", not arrived", course.steps.front().shared_fraction,
             course.steps.back().shared_fraction, falls == course.steps.end() ? "never less" : "once less");
  const MorphReport& report = result.morph.report();
  fmt::print("distances {:.1f} s, evolution {:.1f} s, 16 frames {:.1f} s, {:.2f} GB\n", report.constraint_seconds,
             report.solve_seconds, frame_seconds, 1e-9 * static_cast<double>(peak_memory_bytes()));
  for (const Shape& frame : frames) {
    const MeshMeasures m = measure(std::get<TriangleMesh>(frame));
    fmt::print("volume {:9.3g}, parts {}, genus {}{}\n", m.volume_mm3, m.components, m.genus,
               m.watertight() ? "" : ", not closed");
  }
  const SurfaceDistance to_target = surface_distance(std::get<TriangleMesh>(frames.back()), target);
  fmt::print("last frame to the target, in voxels: mean {:.3f}, largest {:.3f}\n",
             to_target.mean_mm / options.resolution_mm, to_target.largest_mm / options.resolution_mm);
}

}  // namespace
}  // namespace isostack::benchmarks

int main(int argc, char** argv) {
  using isostack::ApproachProfile;
  if (argc < 2) {
    fmt::print(stderr, "usage: morph_level_set B.obj [NODES [identity|clamped|tanh]]\n");
    return 2;
  }
  const std::string profile = argc > 3 ? argv[3] : "identity";
  try {
    isostack::benchmarks::measure_morph(argv[1], argc > 2 ? std::atoi(argv[2]) : 128,
                                        profile == "clamped" ? ApproachProfile::clamped
                                        : profile == "tanh"  ? ApproachProfile::tanh
                                                             : ApproachProfile::identity);
  } catch (const isostack::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  }
}
