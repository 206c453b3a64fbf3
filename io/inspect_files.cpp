#include <Eigen/Geometry>

#include "io/contours/contour_files.h"
#include "io/formats.h"
#include "io/images/image_stack.h"
#include "io/inspect_parts.h"
#include "io/meshes/read_mesh.h"
#include "io/slice_order.h"

namespace isostack {

SeriesSummary inspect_volume(const std::filesystem::path& path) {
  const Format& format = format_for(path, &Format::read_volume_header, "a volume");
  const VolumeHeader header = format.read_volume_header(path);
  const Grid& grid = header.grid;
  std::vector<SlicePose> poses;
  for (int k = 0; k < grid.size.z(); ++k) poses.push_back(pose_of_plane(grid, k, path.string()));
  const Eigen::Vector3d k_direction = grid.index_to_world.linear().col(2);
  if (poses.front().normal().dot(k_direction) < 0) std::reverse(poses.begin(), poses.end());  // gaps are positive
  SeriesSummary summary;
  summarise_poses(poses, grid.size.x(), grid.size.y(), summary);
  summary.kind = summary.encoding = format.name;
  summary.name = path.filename().string();
  summary.value_type = header.value_type;
  summary.warnings = header.warnings;
  return summary;
}

SeriesSummary inspect_images(const std::filesystem::path& path) {
  const auto files = std::filesystem::is_directory(path) ? images_in(path) : std::vector{path};
  const ImageInfo info = image_info(files.front());
  SeriesSummary summary;
  summary.kind = "images";
  summary.name = files.front().filename().string();
  summary.encoding = info.format;
  summary.value_type = info.value_type;
  summary.slice_count = files.size();
  summary.columns = info.columns;
  summary.rows = info.rows;
  summary.warnings.push_back("no spacing: images do not say how large their pixels are; give --spacing");
  return summary;
}

SeriesSummary inspect_mesh(const std::filesystem::path& path) {
  const TriangleMesh mesh = read_mesh(path);
  SeriesSummary summary;
  summary.kind = "mesh";
  summary.name = path.filename().string();
  summary.encoding = format_for(path, &Format::read_mesh, "a mesh").name;
  summary.vertex_count = mesh.vertices_mm.size();
  summary.triangle_count = mesh.triangles.size();
  BoundsBuilder bounds(summary);
  for (const Eigen::Vector3d& vertex : mesh.vertices_mm) bounds.add(vertex);
  return summary;
}

std::vector<SeriesSummary> inspect_contours(const std::filesystem::path& path) {
  std::vector<SeriesSummary> summaries;
  const ContourFile file = read_contour_file(path);
  for (const ContourStack& organ : file.organs) {
    SeriesSummary& summary = summaries.emplace_back();
    if (!organ.slices.empty()) {
      std::vector<SlicePose> poses;
      for (const ContourSlice& slice : organ.slices) poses.push_back(slice.pose);
      std::vector<SlicePose> ordered;
      for (const std::size_t i : order_along_normals(poses)) ordered.push_back(poses[i]);
      const Eigen::Vector2i size = organ.slices.front().size_pixels;
      summarise_poses(ordered, size.x(), size.y(), summary);
    }
    summary.kind = "contours";
    summary.name = organ.name;
    summary.encoding = format_for(path, &Format::read_contours, "contours").name;
    summary.point_count = point_count(organ);
    BoundsBuilder bounds(summary);
    for (const ContourSlice& slice : organ.slices) {
      summary.contour_count += slice.contours.size();
      for (const Contour& contour : slice.contours)
        for (const Eigen::Vector2d& point : contour.points_mm) bounds.add(slice.pose.slice_to_world(point));
    }
  }
  if (!summaries.empty()) summaries.front().warnings = file.warnings;
  return summaries;
}

}  // namespace isostack
