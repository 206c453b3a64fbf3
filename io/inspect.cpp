#include "io/inspect.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "io/contours/contour_files.h"
#include "io/dicom/dicom_header.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "io/images/image_stack.h"
#include "io/inspect_parts.h"
#include "io/stack_geometry.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

void summarise_spacing(const std::vector<SlicePose>& poses, SeriesSummary& summary) {
  summary.smallest_spacing_mm = summary.largest_spacing_mm = poses.front().spacing_mm;
  for (const SlicePose& pose : poses) {
    summary.smallest_spacing_mm = summary.smallest_spacing_mm.cwiseMin(pose.spacing_mm);
    summary.largest_spacing_mm = summary.largest_spacing_mm.cwiseMax(pose.spacing_mm);
  }
}

std::optional<GapSummary> summarise_gaps(const std::vector<SliceGap>& gaps) {
  if (gaps.empty()) return std::nullopt;
  std::vector<double> sorted_mm;
  for (const SliceGap& gap : gaps) sorted_mm.push_back(gap.mm);
  std::sort(sorted_mm.begin(), sorted_mm.end());
  return GapSummary{sorted_mm.front(), sorted_mm[sorted_mm.size() / 2], sorted_mm.back()};
}

std::string orientation_letters(const SlicePose& pose) {
  return {direction_letter(pose.x_axis), direction_letter(pose.y_axis), direction_letter(pose.normal())};
}

/// Of poses in the order of order_along_normals.
std::vector<OrientationSummary> summarise_orientations(const std::vector<SlicePose>& poses) {
  std::vector<OrientationSummary> orientations;
  for (std::size_t i = 0, first = 0; i < poses.size(); ++i) {
    if (i > 0 && !are_parallel(poses[first], poses[i])) first = i;
    if (i == first) orientations.push_back({orientation_letters(poses[i]), 0, poses[i].normal()});
    ++orientations.back().slice_count;
  }
  return orientations;
}

std::vector<SeriesSummary> inspect_folder(const std::filesystem::path& folder) {
  const auto files = files_in(folder, Depth::kAllBelow);
  if (std::any_of(files.begin(), files.end(), looks_like_dicom)) return inspect_dicom(folder);
  if (!images_in(folder).empty()) return {inspect_images(folder)};
  throw InputError(folder.string(), files.empty() ? "the folder is empty" : "the folder holds no readable image",
                   "give a folder of DICOM slices or of PNG/TIFF images, or a file");
}

}  // namespace

char direction_letter(const Eigen::Vector3d& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return direction[axis] >= 0 ? "LPS"[axis] : "RAI"[axis];
}

void BoundsBuilder::add(const Eigen::Vector3d& point_in_world_mm) {
  summary_.lower_mm = empty_ ? point_in_world_mm : summary_.lower_mm.cwiseMin(point_in_world_mm).eval();
  summary_.upper_mm = empty_ ? point_in_world_mm : summary_.upper_mm.cwiseMax(point_in_world_mm).eval();
  empty_ = false;
}

void summarise_poses(const std::vector<SlicePose>& poses, int columns, int rows, SeriesSummary& summary) {
  const SlicePose& first = poses.front();
  const StackGeometry geometry = analyse_stack(poses);
  summary.slice_count = poses.size();
  summary.columns = columns;
  summary.rows = rows;
  summarise_spacing(poses, summary);
  summary.row_direction = first.x_axis;
  summary.column_direction = first.y_axis;
  summary.orientation = orientation_letters(first);
  summary.orientations = summarise_orientations(poses);
  summary.orientation_count = geometry.orientations;
  summary.gaps = summarise_gaps(geometry.gaps);
  summary.tilt_deg = geometry.tilt_deg;
  const double depth_mm = geometry.orientations == 1 ? first.signed_distance_mm(poses.back().origin_mm) : 0;
  summary.extent_mm = {columns * first.spacing_mm.x(), rows * first.spacing_mm.y(), std::abs(depth_mm)};
  BoundsBuilder bounds(summary);
  for (const SlicePose& pose : poses)
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(0, 0), Eigen::Vector2d(columns - 1, 0),
                                          Eigen::Vector2d(0, rows - 1), Eigen::Vector2d(columns - 1, rows - 1)})
      bounds.add(pose.pixel_to_world(corner));
}

std::vector<SeriesSummary> inspect(const std::filesystem::path& path) {
  require_exists(path);
  if (std::filesystem::is_directory(path)) return inspect_folder(path);
  if (looks_like_dicom(path) || is_called_dicom(path)) return inspect_dicom(path);
  if (find_format(path, &Format::read_volume_header)) return {inspect_volume(path)};
  if (find_format(path, &Format::read_slices)) return {inspect_images(path)};
  if (find_format(path, &Format::read_contours) && holds_contours(path)) return inspect_contours(path);
  if (find_format(path, &Format::read_mesh)) return {inspect_mesh(path)};
  if (find_format(path, &Format::read_contours)) return inspect_contours(path);  // says what is wrong with it
  std::vector<std::string_view> extensions;
  for (const Format& format : all_formats())
    extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
  throw_unknown_extension(path, "anything readable", extensions);
}

}  // namespace isostack
