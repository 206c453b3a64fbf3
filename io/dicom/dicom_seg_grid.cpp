#include "io/dicom/dicom_seg_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/slice_order.h"

namespace isostack {

namespace {

/// Positions come in 16 characters, so they may be off by a little.
constexpr double tolerance_of_pixel = 0.02;
constexpr double most_planes_per_frame = 1024, most_voxels = 1u << 31;

std::vector<SlicePose> poses_of(const DicomHeader& image) {
  std::vector<SlicePose> poses;
  for (const DicomHeader& frame : frames_of(image)) poses.push_back(pose_of(frame));
  return poses;
}

bool same_directions_and_spacing(const SlicePose& a, const SlicePose& b) {
  return (a.x_axis - b.x_axis).norm() <= 1e-3 && (a.y_axis - b.y_axis).norm() <= 1e-3 &&
         (a.spacing_mm - b.spacing_mm).norm() <= 1e-4;
}

void require_one_direction(const std::vector<SlicePose>& poses, const DicomHeader& image) {
  for (std::size_t f = 1; f < poses.size(); ++f)
    if (!same_directions_and_spacing(poses[f], poses.front()))
      throw UnevenFrames(fmt::format("{} frame {}", image.name, f + 1),
                         "its orientation or pixel spacing differs from that of the first frame");
}

/// The step nearest to `candidate_mm` that reaches from 0 to the last position, if all lie on its multiples.
std::optional<double> fitting_step(const std::vector<double>& sorted_mm, double candidate_mm,
                                   double tolerance_of_step) {
  const double length_mm = sorted_mm.back() - sorted_mm.front();
  if (!(candidate_mm > 0) || !(length_mm / candidate_mm < 65535)) return std::nullopt;
  const double step_mm = length_mm / std::max(1.0, std::round(length_mm / candidate_mm));
  if (std::abs(step_mm - candidate_mm) > 0.01 * candidate_mm) return std::nullopt;
  const bool fits = std::all_of(sorted_mm.begin(), sorted_mm.end(), [&](double position_mm) {
    const double steps = (position_mm - sorted_mm.front()) / step_mm;
    return std::abs(steps - std::round(steps)) < tolerance_of_step;
  });
  return fits ? std::optional(step_mm) : std::nullopt;
}

double step_between(const std::vector<double>& sorted_mm, double tolerance_mm, const DicomHeader& image) {
  const double claimed_mm = image.frame_parts.front().spacing_between_slices_mm.value_or(0);
  if (const std::optional<double> step_mm = fitting_step(sorted_mm, claimed_mm, 0.05)) return *step_mm;
  double smallest_mm = sorted_mm.back() - sorted_mm.front();
  for (std::size_t i = 1; i < sorted_mm.size(); ++i)
    if (const double gap_mm = sorted_mm[i] - sorted_mm[i - 1]; gap_mm > tolerance_mm)
      smallest_mm = std::min(smallest_mm, gap_mm);
  for (int parts = 1; parts <= 3; ++parts)  // more would fit whatever comes
    if (const std::optional<double> step_mm = fitting_step(sorted_mm, smallest_mm / parts, 0.01)) return *step_mm;
  throw UnevenFrames(image.name, "its frames are not evenly spaced");
}

/// Thickness of a single plane.
double lone_step(const DicomHeader& image, FrameGrid& result) {
  const DicomFrame& frame = image.frame_parts.front();
  for (const auto& known_mm : {frame.spacing_between_slices_mm, frame.slice_thickness_mm})
    if (known_mm && *known_mm > 0 && std::isfinite(*known_mm)) return *known_mm;
  result.warnings.push_back("unknown thickness: one plane without spacing or thickness; 1 mm is assumed");
  return 1;
}

void require_sensible_size(const Grid& grid, double planes, const DicomHeader& image) {
  const double voxels = 1.0 * grid.size.x() * grid.size.y() * planes;
  if (planes > 65536 || planes > most_planes_per_frame * image.frames || voxels > most_voxels)
    throw GeometryError(image.name, fmt::format("its {} frames are spread over {:.0f} planes", image.frames, planes),
                        "check the frames' positions; the file may be damaged");
}

}  // namespace

UnevenFrames::UnevenFrames(const std::string& where, const std::string& problem)
    : GeometryError(where, problem,
                    "it fits into no label volume: take contours, which keep each plane's place (`segment`, `convert` "
                    "to .vtp or .json, `reconstruct`), or export it on an evenly spaced series"),
      problem_(problem) {}

FrameGrid grid_of_frames(const DicomHeader& image) {
  const std::vector<SlicePose> poses = poses_of(image);
  require_one_direction(poses, image);
  FrameGrid result;
  const SlicePose& any = poses.front();
  const double tolerance_mm = tolerance_of_pixel * any.spacing_mm.minCoeff();
  std::vector<double> positions_mm;
  for (const SlicePose& pose : poses) positions_mm.push_back(any.signed_distance_mm(pose.origin_mm));
  const auto [lowest, highest] = std::minmax_element(positions_mm.begin(), positions_mm.end());
  const double length_mm = *highest - *lowest, lowest_mm = *lowest;
  const Eigen::Vector3d first_mm = poses[static_cast<std::size_t>(lowest - positions_mm.begin())].origin_mm;
  const Eigen::Vector3d last_mm = poses[static_cast<std::size_t>(highest - positions_mm.begin())].origin_mm;
  const bool is_one_plane = length_mm <= tolerance_mm;
  std::vector<double> sorted_mm = positions_mm;
  std::sort(sorted_mm.begin(), sorted_mm.end());
  const double step_mm = is_one_plane ? lone_step(image, result) : step_between(sorted_mm, tolerance_mm, image);
  // Along the origins, which need not go along the normal (gantry tilt).
  const Eigen::Vector3d step = is_one_plane ? Eigen::Vector3d(any.normal() * step_mm)
                                            : Eigen::Vector3d((last_mm - first_mm) / length_mm * step_mm);

  Grid& grid = result.grid;
  grid.size = {image.columns, image.rows, 1};
  const double planes = is_one_plane ? 1 : std::round(length_mm / step_mm) + 1;
  require_sensible_size(grid, planes, image);
  grid.size.z() = static_cast<int>(planes);
  grid.index_to_world.translation() = first_mm;
  grid.index_to_world.linear() << any.x_axis * any.spacing_mm.x(), any.y_axis * any.spacing_mm.y(), step;
  for (std::size_t f = 0; f < poses.size(); ++f) {
    const int k = is_one_plane ? 0 : static_cast<int>(std::lround((positions_mm[f] - lowest_mm) / step_mm));
    const Eigen::Vector3d off_mm = poses[f].origin_mm - (first_mm + k * step);
    if (std::hypot(off_mm.dot(any.x_axis), off_mm.dot(any.y_axis)) > 2 * tolerance_mm)
      throw UnevenFrames(fmt::format("{} frame {}", image.name, f + 1), "it is shifted against the other frames");
    result.plane_of_frame.push_back(k);
  }
  return result;
}

std::vector<FrameGrid> planes_of_frames(const DicomHeader& image) {
  const std::vector<SlicePose> poses = poses_of(image);
  const double tolerance_mm = tolerance_of_pixel * poses.front().spacing_mm.minCoeff();
  std::vector<std::size_t> firsts;  // frame that stands for each plane
  std::vector<std::size_t> plane_of(poses.size());
  for (std::size_t f = 0; f < poses.size(); ++f) {
    const auto same = std::find_if(firsts.begin(), firsts.end(), [&](std::size_t first) {
      return same_directions_and_spacing(poses[first], poses[f]) &&
             (poses[first].origin_mm - poses[f].origin_mm).norm() <= tolerance_mm;
    });
    plane_of[f] = static_cast<std::size_t>(same - firsts.begin());
    if (same == firsts.end()) firsts.push_back(f);
  }
  std::vector<SlicePose> places;
  for (const std::size_t first : firsts) places.push_back(poses[first]);
  require_sensible_size({.size = {image.columns, image.rows, 1}}, static_cast<double>(places.size()), image);
  std::vector<FrameGrid> grids;
  for (const std::size_t place : order_along_normals(places)) {
    FrameGrid& plane = grids.emplace_back();
    const SlicePose& pose = places[place];
    const double thickness_mm = image.frame_parts[firsts[place]].slice_thickness_mm.value_or(0);
    plane.grid.size = {image.columns, image.rows, 1};
    plane.grid.index_to_world.translation() = pose.origin_mm;
    plane.grid.index_to_world.linear() << pose.x_axis * pose.spacing_mm.x(), pose.y_axis * pose.spacing_mm.y(),
        pose.normal() * (thickness_mm > 0 && std::isfinite(thickness_mm) ? thickness_mm : 1.0);
    for (std::size_t f = 0; f < poses.size(); ++f) plane.plane_of_frame.push_back(plane_of[f] == place ? 0 : -1);
  }
  return grids;
}

}  // namespace isostack
