// isostack_make_phantom OUT_DIR: writes the phantom as DICOM slices together with its true surface. Same bytes on
// every run.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "io/atomic_file.h"
#include "io/dicom/write_dicom.h"
#include "io/meshes/write_mesh.h"
#include "recon/metrics/mesh_measures.h"
#include "sample_data/phantom.h"
#include "sample_data/phantom_surface.h"

namespace {

using namespace isostack;

constexpr std::uint64_t seed = 20240611;
constexpr double lattice_mm = 0.75;

/// The pose of a square image of `pixels` x `pixels` of 1 mm whose centre is `centre_mm`.
SlicePose centred_pose(const Eigen::Matrix3d& axes, const Eigen::Vector3d& centre_mm, int pixels) {
  SlicePose pose;
  pose.x_axis = axes.col(0);
  pose.y_axis = axes.col(1);
  pose.origin_mm = centre_mm - (pixels - 1) / 2.0 * (pose.x_axis + pose.y_axis);
  return pose;
}

PhantomImaging imaging_of(std::uint64_t series, std::uint64_t index) {
  PhantomImaging imaging;
  imaging.seed = seed + 1000 * series + index;
  return imaging;
}

/// Thirty parallel oblique slices with gaps from 2.5 to 5 mm.
SliceStack parallel_series() {
  constexpr int slice_count = 30, pixels = 128;
  const Eigen::Matrix3d axes =
      (Eigen::AngleAxisd(0.30, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.22, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(0.15, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> gap_mm(2.5, 5.0);
  std::vector<double> positions_mm = {0};
  while (positions_mm.size() < slice_count) positions_mm.push_back(positions_mm.back() + gap_mm(random));

  SliceStack stack{.name = "series", .slices = {}, .warnings = {}};
  const Eigen::Vector3d middle = phantom_bounds_mm().center();
  for (std::size_t k = 0; k < positions_mm.size(); ++k) {
    const double offset_mm = positions_mm[k] - positions_mm.back() / 2;
    const SlicePose pose = centred_pose(axes, middle + offset_mm * axes.col(2), pixels);
    stack.slices.push_back(render_phantom_slice(pose, {pixels, pixels}, imaging_of(1, k)));
  }
  return stack;
}

/// Planes of twelve orientations spread evenly over the half sphere, near the phantom's middle.
SliceStack crossing_planes() {
  constexpr int plane_count = 12, pixels = 160;
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  SliceStack stack{.name = "planes", .slices = {}, .warnings = {}};
  for (int k = 0; k < plane_count; ++k) {
    const double height = (k + 0.5) / plane_count, ring = std::sqrt(1 - height * height);
    const Eigen::Vector3d normal(ring * std::cos(k * golden_angle), ring * std::sin(k * golden_angle), height);
    const Eigen::Matrix3d axes =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal).toRotationMatrix();
    const double offset_mm = 12 * std::sin(2.4 * k);
    const SlicePose pose = centred_pose(axes, phantom_bounds_mm().center() + offset_mm * normal, pixels);
    stack.slices.push_back(render_phantom_slice(pose, {pixels, pixels}, imaging_of(2, static_cast<std::uint64_t>(k))));
  }
  return stack;
}

void write_series(const SliceStack& stack, int series_number, const std::filesystem::path& folder) {
  DicomSeriesOptions options;
  options.seed = seed + static_cast<std::uint64_t>(series_number);
  options.series_number = series_number;
  options.description = "synthetic phantom, " + stack.name;
  write_dicom_series(stack, folder, options);
}

void make_phantom(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_series(parallel_series(), 1, folder / "series");
  write_series(crossing_planes(), 2, folder / "planes");

  const TriangleMesh surface = phantom_surface(lattice_mm);
  write_mesh(surface, folder / "truth.stl");
  const MeshMeasures measures = measure(surface);
  const nlohmann::ordered_json truth = {{"volume_mm3", measures.volume_mm3},
                                        {"area_mm2", measures.area_mm2},
                                        {"genus", measures.genus},
                                        {"components", measures.components},
                                        {"lattice_mm", lattice_mm},
                                        {"level_hu", PhantomImaging().level_hu()},
                                        {"noise_hu", PhantomImaging().noise_hu},
                                        {"seed", seed}};
  write_whole_file(folder / "truth.json", truth.dump(2) + "\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || std::string(argv[1]).starts_with("-")) {
    std::fputs("usage: isostack_make_phantom OUT_DIR\n", stderr);
    return 2;
  }
  try {
    make_phantom(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
  return 0;
}
