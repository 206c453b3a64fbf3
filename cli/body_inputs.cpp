#include "cli/body_inputs.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "io/contours/contour_files.h"
#include "io/dicom/dicom_header.h"
#include "io/formats.h"
#include "io/meshes/read_mesh.h"
#include "io/solid_file.h"
#include "io/volumes/volume_files.h"
#include "recon/distance/distance_surface.h"
#include "recon/distance/mended_mesh.h"
#include "recon/distance/solid.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

TriangleMesh surface_of(const CsgSolid& solid, Session& session) {
  const double voxel_mm = box_of(solid).sizes().maxCoeff() / 100;
  const Grid grid = distance_grid(solid, voxel_mm, 3 * voxel_mm);
  const SolidDistanceOptions near{.tolerance_mm = 0.1 * voxel_mm, .extent = DistanceExtent::band};
  return distance_surface(solid_distance(solid, grid, near, session.progress()).distance_mm, {}, session.progress());
}

TriangleMesh surface_of_distances(const std::filesystem::path& path, const BodyOptions& options, Session& session) {
  const Volume<float> distances = read_distance_volume(path, options);
  const auto is_finite = [](float mm) { return std::isfinite(mm); };
  if (!std::all_of(distances.voxels.begin(), distances.voxels.end(), is_finite))
    throw InputError(path.string(), "a distance in it is not finite", "make the distance volume again");
  const auto [low, high] = std::minmax_element(distances.voxels.begin(), distances.voxels.end());
  if (!(*low < 0 && *high > 0))
    throw InputError(path.string(), fmt::format("its distances, {:.3g} to {:.3g} mm, have one sign", *low, *high),
                     "give a volume that is positive inside and negative outside");
  return distance_surface(distances, {}, session.progress());
}

TriangleMesh mended(TriangleMesh mesh, const std::filesystem::path& path, Session& session) {
  mesh.name = path.filename().string();
  MendedMesh result = mended_mesh(mesh, session.progress());
  for (const std::string& remark : result.remarks) session.note(mesh.name + ": " + remark);
  return std::move(result.mesh);
}

}  // namespace

void add_distance_option(CLI::App& command, BodyOptions& options) {
  command
      .add_option("--distances", options.distances,
                  "Volumes of real numbers are signed distances in mm, positive inside or outside, though their "
                  "headers do not say so")
      ->check(CLI::IsMember({"inside", "outside"}));
}

void add_mend_option(CLI::App& command, BodyOptions& options) {
  command.add_flag("--mend", options.mend,
                   "Close meshes with holes and unite what crosses, by way of a distance volume, instead of refusing");
}

bool is_mesh(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path) || !find_format(path, &Format::read_mesh)) return false;
  return !find_format(path, &Format::read_contours) || !holds_contours(path);
}

bool is_distance_volume(const std::filesystem::path& path, const BodyOptions& options) {
  if (!std::filesystem::is_regular_file(path) || looks_like_dicom(path)) return false;
  const Format* format = find_format(path, &Format::read_volume_header);
  if (format == nullptr) return false;
  const VolumeHeader header = format->read_volume_header(path);
  const bool is_real = header.value_type == "float" || header.value_type == "double";
  return header.is_distance || (is_real && !options.distances.empty());
}

Volume<float> read_distance_volume(const std::filesystem::path& path, const BodyOptions& options) {
  Volume<float> distances = read_volume(path);
  const Format* format = find_format(path, &Format::read_volume_header);
  const bool is_marked = format != nullptr && format->read_volume_header(path).is_distance;
  if (!is_marked && options.distances == "outside")
    for (float& mm : distances.voxels) mm = -mm;
  return distances;
}

std::optional<TriangleMesh> read_body(const std::filesystem::path& path, const BodyOptions& options, Session& session) {
  if (holds_solid(path)) return surface_of(read_solid(path), session);
  if (is_distance_volume(path, options)) return surface_of_distances(path, options, session);
  if (!is_mesh(path)) return std::nullopt;
  TriangleMesh mesh = read_mesh(path);
  return options.mend ? mended(std::move(mesh), path, session) : std::move(mesh);
}

}  // namespace isostack::cli
