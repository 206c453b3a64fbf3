#include "io/dicom/rtstruct_planes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "io/contours/plane_pose.h"

namespace isostack {

namespace {

constexpr double same_plane_mm = 0.1;  // coordinates of some programs are rounded to a tenth
constexpr double not_planar_mm = 0.5;  // from the mean plane; beyond, a projection would move the contour visibly

struct Placed {
  std::size_t roi = 0, contour = 0;
  int direction = -1;
  double height_mm = 0;
};

/// Twice the area enclosed, as a vector along the normal (Newell's method).
Eigen::Vector3d newell_vector(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::Vector3d& origin = points.front();
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += (points[i] - origin).cross(points[(i + 1) % points.size()] - origin);
  return sum;
}

struct Heights {
  double middle_mm = 0, half_spread_mm = 0;
};

Heights heights_along(const Eigen::Vector3d& normal, const std::vector<Eigen::Vector3d>& points) {
  double low = normal.dot(points.front()), high = low;
  for (const Eigen::Vector3d& point : points) {
    low = std::min(low, normal.dot(point));
    high = std::max(high, normal.dot(point));
  }
  return {(low + high) / 2, (high - low) / 2};
}

/// The sign that makes y run towards posterior or inferior, whichever is nearer, in pose_of_plane.
Eigen::Vector3d with_usual_sign(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d y = pose_of_plane(normal, 0).y_axis;
  return y.y() - y.z() >= 0 ? normal : Eigen::Vector3d(-normal);
}

class PlaneFinder {
 public:
  PlaneFinder(const std::vector<RtRoi>& rois, const std::vector<ContourSlice>& images) : rois_(rois), images_(images) {
    for (const ContourSlice& image : images_) {
      const auto known = std::find_if(normals_.begin(), normals_.end(), [&](const Eigen::Vector3d& normal) {
        return normal.cross(image.pose.normal()).norm() < 1e-3;
      });
      image_direction_.push_back(static_cast<int>(known - normals_.begin()));
      if (known == normals_.end()) normals_.push_back(image.pose.normal());
    }
  }

  RtPlanes find() {
    for (const RtRoi& roi : rois_) result_.plane_of.emplace_back(roi.contours.size(), -1);
    for (const auto& [roi, contour] : closed_by_area()) place(roi, contour);
    for (std::size_t i = 0; i < rois_.size(); ++i)
      if (left_out_.contains(i))
        result_.warnings.push_back(
            fmt::format("{}: {} of its contours left out, for they do not lie in a plane (up to {:.1f} mm off) or "
                        "enclose nothing",
                        rois_[i].name, left_out_[i].first, left_out_[i].second));
    for (int direction = 0; direction < static_cast<int>(normals_.size()); ++direction) make_planes(direction);
    return std::move(result_);
  }

 private:
  /// Large contours tell the direction best.
  std::vector<std::pair<std::size_t, std::size_t>> closed_by_area() const {
    std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> order;
    for (std::size_t i = 0; i < rois_.size(); ++i)
      for (std::size_t j = 0; j < rois_[i].contours.size(); ++j) {
        const RtContour& contour = rois_[i].contours[j];
        if (is_closed(contour)) order.push_back({-newell_vector(contour.points_mm).norm(), {i, j}});
      }
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::pair<std::size_t, std::size_t>> closed;
    for (const auto& [negative_area, contour] : order) closed.push_back(contour);
    return closed;
  }

  void leave_out(std::size_t roi, double deviation_mm) {
    auto& [count, largest_mm] = left_out_[roi];
    ++count;
    largest_mm = std::max(largest_mm, deviation_mm);
  }

  void place(std::size_t roi, std::size_t contour) {
    const std::vector<Eigen::Vector3d>& points = rois_[roi].contours[contour].points_mm;
    const Eigen::Vector3d area = newell_vector(points);
    if (!(area.norm() > 1e-9) || !area.allFinite()) return leave_out(roi, 0);
    const Eigen::Vector3d normal = area.normalized();
    int best = -1;
    Heights best_heights{0, same_plane_mm};
    for (std::size_t d = 0; d < normals_.size(); ++d) {
      if (std::abs(normals_[d].dot(normal)) < 0.5) continue;
      const Heights heights = heights_along(normals_[d], points);
      if (heights.half_spread_mm > best_heights.half_spread_mm) continue;
      if (best >= 0 && heights.half_spread_mm == best_heights.half_spread_mm) continue;
      best = static_cast<int>(d);
      best_heights = heights;
    }
    if (best < 0) {
      const Eigen::Vector3d own = with_usual_sign(normal);
      best_heights = heights_along(own, points);
      if (best_heights.half_spread_mm > not_planar_mm) return leave_out(roi, best_heights.half_spread_mm);
      best = static_cast<int>(normals_.size());
      normals_.push_back(own);
    }
    placed_.push_back({roi, contour, best, best_heights.middle_mm});
  }

  /// One plane for each height that contours or images of the direction have.
  void make_planes(int direction) {
    struct Entry {
      double height_mm;
      const Placed* contour;  // null: an image
      const ContourSlice* image;
    };
    const Eigen::Vector3d& normal = normals_[static_cast<std::size_t>(direction)];
    std::vector<Entry> entries;
    for (const Placed& placed : placed_)
      if (placed.direction == direction) entries.push_back({placed.height_mm, &placed, nullptr});
    for (std::size_t i = 0; i < images_.size(); ++i)
      if (image_direction_[i] == direction)
        entries.push_back({normal.dot(images_[i].pose.origin_mm), nullptr, &images_[i]});
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.height_mm < b.height_mm; });
    for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
      double sum_mm = 0, count = 0;
      const ContourSlice* image = nullptr;
      for (end = begin; end < entries.size() && entries[end].height_mm - entries[begin].height_mm <= same_plane_mm;
           ++end) {
        const Entry& entry = entries[end];
        if (entry.image && !image) image = entry.image;
        if (!entry.contour) continue;
        sum_mm += entry.height_mm;
        ++count;
        result_.plane_of[entry.contour->roi][entry.contour->contour] = static_cast<int>(result_.planes.size());
      }
      add_plane(direction, count > 0 ? sum_mm / count : entries[begin].height_mm, image);
    }
  }

  void add_plane(int direction, double height_mm, const ContourSlice* image) {
    const Eigen::Vector3d& normal = normals_[static_cast<std::size_t>(direction)];
    ContourSlice plane;
    const ContourSlice* nearest = image ? image : nearest_image(direction, height_mm);
    plane.pose = nearest ? nearest->pose : pose_of_plane(normal, height_mm);
    if (nearest) {
      const double shift_mm = height_mm - normal.dot(nearest->pose.origin_mm);
      constexpr double rounding_mm = 1e-3;
      if (std::abs(shift_mm) > rounding_mm) plane.pose.origin_mm += shift_mm * normal;
      plane.size_pixels = nearest->size_pixels;
    }
    plane.name = image ? image->name : name_of(normal, height_mm);
    result_.planes.push_back(std::move(plane));
    result_.direction_of.push_back(direction);
    result_.height_mm.push_back(height_mm);
  }

  const ContourSlice* nearest_image(int direction, double height_mm) const {
    const ContourSlice* nearest = nullptr;
    double nearest_mm = 0;
    for (std::size_t i = 0; i < images_.size(); ++i) {
      if (image_direction_[i] != direction) continue;
      const double distance_mm =
          std::abs(normals_[static_cast<std::size_t>(direction)].dot(images_[i].pose.origin_mm) - height_mm);
      if (nearest && distance_mm >= nearest_mm) continue;
      nearest = &images_[i];
      nearest_mm = distance_mm;
    }
    return nearest;
  }

  static std::string name_of(const Eigen::Vector3d& normal, double height_mm) {
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(normal[axis]) > 1 - 1e-9) return fmt::format("{} {:.2f} mm", "xyz"[axis], normal[axis] * height_mm);
    return fmt::format("plane {:.2f} mm along ({:.3f}, {:.3f}, {:.3f})", height_mm, normal.x(), normal.y(), normal.z());
  }

  const std::vector<RtRoi>& rois_;
  const std::vector<ContourSlice>& images_;
  std::vector<int> image_direction_;
  std::vector<Eigen::Vector3d> normals_;  ///< of each direction
  std::vector<Placed> placed_;
  std::map<std::size_t, std::pair<int, double>> left_out_;  ///< per ROI: how many, largest deviation
  RtPlanes result_;
};

}  // namespace

bool is_closed(const RtContour& contour) {
  return (contour.type == "CLOSED_PLANAR" || contour.type == "CLOSEDPLANAR_XOR") && contour.points_mm.size() >= 3;
}

RtPlanes find_planes(const std::vector<RtRoi>& rois, const std::vector<ContourSlice>& images) {
  return PlaneFinder(rois, images).find();
}

}  // namespace isostack
