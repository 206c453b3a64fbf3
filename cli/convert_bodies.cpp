#include "cli/convert_bodies.h"

#include <CLI/CLI.hpp>
#include <utility>

#include "cli/path_roles.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "io/meshes/read_mesh.h"
#include "io/meshes/write_mesh.h"
#include "io/solid_file.h"
#include "io/volumes/volume_files.h"
#include "recon/distance/mesh_distance.h"
#include "recon/distance/solid.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

constexpr double voxels_across = 100, margin_voxels = 5;

/// --grid, or voxels of --voxel (a hundredth of the longest side) round the body.
template <class Body>
Grid grid_for(const Body& body, double longest_mm, const BodyConversion& options) {
  if (!options.grid.empty()) return read_grid(options.grid);
  const double voxel_mm = options.voxel_mm > 0 ? options.voxel_mm : longest_mm / voxels_across;
  return distance_grid(body, voxel_mm, margin_voxels * voxel_mm);
}

Volume<float> distances_to_solid(const std::filesystem::path& input, const BodyConversion& options, Session& session) {
  const CsgSolid solid = read_solid(input);
  const Grid grid = grid_for(solid, box_of(solid).sizes().maxCoeff(), options);
  SolidDistance found = solid_distance(solid, grid, {}, session.progress());
  session.result["error_mm"] = found.error_mm;
  return std::move(found.distance_mm);
}

Volume<float> distances_to_mesh(const std::filesystem::path& input, const BodyConversion& options, Session& session) {
  const bool mend = options.bodies.mend;
  const TriangleMesh mesh = mend ? *read_body(input, options.bodies, session) : read_mesh(input);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices_mm) box.extend(v);
  MeshDistance found = mesh_distance(mesh, grid_for(mesh, box.sizes().maxCoeff(), options), {}, session.progress());
  for (const std::string& remark : found.remarks) session.note(input.filename().string() + ": " + remark);
  return std::move(found.distance_mm);
}

}  // namespace

void add_body_options(CLI::App& command, BodyConversion& options) {
  auto* voxel = command
                    .add_option("--voxel", options.voxel_mm,
                                "Mesh or solid to a volume of signed distances with voxels of this edge, mm")
                    ->check(CLI::PositiveNumber)
                    ->type_name("MM");
  command.add_option("--grid", options.grid, "The same on the grid of this volume")
      ->check(read_path())
      ->check(read_path())
      ->excludes(voxel)
      ->type_name("REF");
  add_distance_option(command, options.bodies);
  add_mend_option(command, options.bodies);
}

bool converts_body(const std::filesystem::path& input, const std::filesystem::path& output,
                   const BodyConversion& options) {
  require_exists(input);
  const bool to_mesh =
      find_format(output, &Format::write_mesh) != nullptr && !find_format(output, &Format::write_volume);
  const bool to_volume = find_format(output, &Format::write_volume) != nullptr;
  if (holds_solid(input)) return to_mesh || to_volume;
  if (is_distance_volume(input, options.bodies)) return to_mesh || (to_volume && !options.bodies.distances.empty());
  if (is_mesh(input)) return to_volume ? options.voxel_mm > 0 || !options.grid.empty() : to_mesh && options.bodies.mend;
  return false;
}

void convert_body(const std::filesystem::path& input, const std::filesystem::path& output,
                  const BodyConversion& options, const WriteOptions& writing, Session& session) {
  if (!find_format(output, &Format::write_volume)) {
    write_mesh(*read_body(input, options.bodies, session), output, writing);
    return;
  }
  const Volume<float> distances = holds_solid(input) ? distances_to_solid(input, options, session)
                                  : is_mesh(input)   ? distances_to_mesh(input, options, session)
                                                     : read_distance_volume(input, options.bodies);
  const Eigen::Vector3i& size = distances.grid.size;
  session.result["voxels"] = {size.x(), size.y(), size.z()};
  write_volume(stored_distances_of(distances), output, writing);
}

}  // namespace isostack::cli
