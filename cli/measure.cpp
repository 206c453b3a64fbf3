#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/json_report.h"
#include "io/formats.h"
#include "io/read_mesh.h"
#include "io/volume_files.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/overlap.h"
#include "recon/metrics/surface_distance.h"
#include "recon/metrics/voxelize.h"

namespace isostack::cli {

namespace {

struct MeasureCommand {
  std::filesystem::path shape, against;
  int label = 0;
};

/// A surface or a label volume (voxels of the chosen label, or all that are not 0).
struct Shape {
  std::optional<TriangleMesh> mesh;
  std::optional<LabelVolume> labels;
};

Shape read_shape(const std::filesystem::path& path, int label) {
  Shape shape;
  if (find_format(path, &Format::read_mesh) != nullptr) {
    shape.mesh = read_mesh(path);
    return shape;
  }
  const Volume<float> volume = read_volume(path);
  shape.labels = LabelVolume(volume.grid);
  std::transform(volume.voxels.begin(), volume.voxels.end(), shape.labels->voxels.begin(), [&](float value) {
    return static_cast<std::uint16_t>(label == 0 ? value != 0 : value == static_cast<float>(label));
  });
  return shape;
}

void describe(const std::filesystem::path& path, const Shape& shape, const char* key, Session& session) {
  session.text += path.string() + "\n";
  if (shape.mesh) {
    const MeshMeasures measures = measure(*shape.mesh);
    session.result[key] = to_json(measures);
    session.text += to_text(measures);
    return;
  }
  const auto count = static_cast<std::size_t>(
      std::count_if(shape.labels->voxels.begin(), shape.labels->voxels.end(), [](auto v) { return v != 0; }));
  const double volume_mm3 = static_cast<double>(count) * shape.labels->grid.voxel_volume_mm3();
  session.result[key] = {{"volume_mm3", volume_mm3}, {"voxels", count}};
  session.text += fmt::format("  volume      {:.3f} cm3\n  voxels      {}\n", volume_mm3 / 1000, count);
}

/// A cubic grid round both meshes with about 200 voxels along the diagonal.
Grid common_grid(const TriangleMesh& a, const TriangleMesh& b) {
  Eigen::AlignedBox3d box;
  for (const TriangleMesh* mesh : {&a, &b})
    for (const Eigen::Vector3d& v : mesh->vertices_mm) box.extend(v);
  const double spacing_mm = box.diagonal().norm() / 200;
  Grid grid;
  grid.size = (box.sizes() / spacing_mm).array().ceil().cast<int>() + 2;
  grid.index_to_world = Eigen::Translation3d(box.min()) * Eigen::Scaling(spacing_mm);
  return grid;
}

LabelVolume on_grid(const Shape& shape, const Grid& grid) {
  if (shape.labels) return *shape.labels;
  LabelVolume labels(grid);
  voxelize(*shape.mesh, 1, labels);
  return labels;
}

void compare(const Shape& a, const Shape& b, Session& session) {
  Grid grid = a.labels ? a.labels->grid : b.labels ? b.labels->grid : common_grid(*a.mesh, *b.mesh);
  if (a.labels && b.labels && !a.labels->grid.index_to_world.isApprox(b.labels->grid.index_to_world, 1e-4))
    throw InputError("measure", "the two label volumes lie on different grids",
                     "put one on the other's grid with --grid");
  const Overlap shared = overlap(on_grid(a, grid), on_grid(b, grid));
  nlohmann::json& entry = session.result["comparison"];
  entry["dice"] = shared.dice;
  session.text += fmt::format("  Dice        {:.4f}\n", shared.dice);
  if (!a.mesh || !b.mesh) return;
  const SurfaceDistance distance = surface_distance(*a.mesh, *b.mesh);
  entry["mean_distance_mm"] = distance.mean_mm;
  entry["percentile95_distance_mm"] = distance.percentile95_mm;
  entry["largest_distance_mm"] = distance.largest_mm;
  session.text += fmt::format("  distance    mean {:.3f} mm, 95 % {:.3f} mm, largest {:.3f} mm\n", distance.mean_mm,
                              distance.percentile95_mm, distance.largest_mm);
}

void run_measure(const MeasureCommand& command, Session& session) {
  const Shape shape = read_shape(command.shape, command.label);
  describe(command.shape, shape, "shape", session);
  if (command.against.empty()) return;
  const Shape against = read_shape(command.against, command.label);
  describe(command.against, against, "against", session);
  compare(shape, against, session);
}

}  // namespace

void add_measure(CLI::App& app, Session& session) {
  auto options = std::make_shared<MeasureCommand>();
  CLI::App* command = app.add_subcommand("measure", "Volume, area, topology of a surface or label volume; comparison");
  command->add_option("A", options->shape, "Surface (.stl, .ply, .obj, .vtp) or label volume")->required();
  command->add_option("--against", options->against, "Compare with this one")->type_name("B");
  command->add_option("--label", options->label, "Label volumes: this label (default: all that are not 0)")
      ->check(CLI::PositiveNumber);
  command->callback([options, &session] { session.run = [options, &session] { run_measure(*options, session); }; });
}

}  // namespace isostack::cli
