#include "segmentation/trace_contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace isostack {

namespace {

constexpr double min_distance_to_centre_pixels = 1e-3;

/// Marching squares over the image with a ring of outside nodes around it, so that every curve closes.
/// Nodes are numbered row by row over the ringed raster. Edge 2·n joins node n to its right neighbour,
/// edge 2·n + 1 to the one below.
class Tracer {
 public:
  Tracer(const Image<float>& phi, const Eigen::Vector2d& spacing_mm)
      : phi_(phi), spacing_mm_(spacing_mm), rows_(phi.rows() + 2), columns_(phi.cols() + 2) {}

  std::vector<Contour> run() {
    link_segments();
    // The first crossing of a curve met row by row has the curve wholly to its right, so the crossing
    // just before it in the row tells the nesting.
    for (Eigen::Index row = 0; row < rows_; ++row) {
      int previous = -1;
      for (Eigen::Index column = 0; column + 1 < columns_; ++column) {
        const std::size_t edge = 2 * node(row, column);
        if (next_[edge] < 0) continue;
        if (contour_of_[edge] < 0) follow(edge, depth_after(previous, is_inside_node(row, column)));
        previous = contour_of_[edge];
      }
    }
    return std::move(contours_);
  }

 private:
  std::size_t node(Eigen::Index row, Eigen::Index column) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }
  bool is_ring(Eigen::Index row, Eigen::Index column) const {
    return row == 0 || column == 0 || row == rows_ - 1 || column == columns_ - 1;
  }
  double value(Eigen::Index row, Eigen::Index column) const {
    return is_ring(row, column) ? -1.0 : static_cast<double>(phi_(row - 1, column - 1));
  }
  bool is_inside_node(Eigen::Index row, Eigen::Index column) const { return value(row, column) >= 0; }

  /// A curve leaving the organ towards outside is a hole when the gap before it is organ.
  int depth_after(int previous, bool gap_is_inside) const {
    if (previous < 0) return 0;
    const int depth = contours_[static_cast<std::size_t>(previous)].depth;
    return (depth % 2 == 1) == gap_is_inside ? depth : depth + 1;
  }

  void link_segments() {
    next_.assign(2 * static_cast<std::size_t>(rows_ * columns_), -1);
    contour_of_.assign(next_.size(), -1);
    for (Eigen::Index row = 0; row + 1 < rows_; ++row)
      for (Eigen::Index column = 0; column + 1 < columns_; ++column) link_cell(row, column);
  }

  /// Joins the crossings on the cell's sides by segments that keep the organ to their left. Corners and sides
  /// are numbered in the direction from x to y: side k joins corner k to corner k + 1.
  void link_cell(Eigen::Index row, Eigen::Index column) {
    const std::array<double, 4> corner = {value(row, column), value(row, column + 1), value(row + 1, column + 1),
                                          value(row + 1, column)};
    std::array<bool, 4> inside;
    for (int k = 0; k < 4; ++k) inside[k] = corner[k] >= 0;
    const int inside_count = inside[0] + inside[1] + inside[2] + inside[3];
    if (inside_count == 0 || inside_count == 4) return;

    const std::array<std::size_t, 4> side = {2 * node(row, column), 2 * node(row, column + 1) + 1,
                                             2 * node(row + 1, column), 2 * node(row, column) + 1};
    const bool is_saddle = inside_count == 2 && inside[0] == inside[2];
    const bool joins_organ = is_saddle && saddle_is_inside(corner);
    for (int k = 0; k < 4; ++k) {
      if (!inside[k] || inside[(k + 1) % 4]) continue;
      int end = (k + (joins_organ ? 1 : 3)) % 4;
      if (!is_saddle)
        for (end = 0; inside[end] || !inside[(end + 1) % 4];) ++end;
      next_[side[k]] = static_cast<std::int64_t>(side[end]);
    }
  }

  static bool saddle_is_inside(const std::array<double, 4>& corner) {
    // The denominator has one sign, that of corner 0 and 2.
    const double numerator = corner[0] * corner[2] - corner[1] * corner[3];
    return corner[0] >= 0 ? numerator >= 0 : numerator <= 0;
  }

  void follow(std::size_t first, int depth) {
    Contour contour;
    contour.depth = depth;
    std::size_t edge = first;
    do {
      contour_of_[edge] = static_cast<int>(contours_.size());
      contour.points_mm.push_back(crossing_mm(edge));
      edge = static_cast<std::size_t>(next_[edge]);
    } while (edge != first);
    contours_.push_back(std::move(contour));
  }

  Eigen::Vector2d crossing_mm(std::size_t edge) const {
    const Eigen::Index row = static_cast<Eigen::Index>(edge / 2) / columns_;
    const Eigen::Index column = static_cast<Eigen::Index>(edge / 2) % columns_;
    const bool is_vertical = edge % 2 == 1;
    const Eigen::Index next_row = row + is_vertical, next_column = column + !is_vertical;
    double t = 0.5;
    if (!is_ring(row, column) && !is_ring(next_row, next_column)) {
      const double a = value(row, column), b = value(next_row, next_column);
      t = a / (a - b);
      if (!std::isfinite(t)) t = 0.5;
      t = std::clamp(t, min_distance_to_centre_pixels, 1 - min_distance_to_centre_pixels);
    }
    const Eigen::Vector2d pixel(static_cast<double>(column - 1) + (is_vertical ? 0 : t),
                                static_cast<double>(row - 1) + (is_vertical ? t : 0));
    return pixel.cwiseProduct(spacing_mm_);
  }

  const Image<float>& phi_;
  const Eigen::Vector2d spacing_mm_;
  const Eigen::Index rows_, columns_;
  std::vector<std::int64_t> next_;  ///< the crossing that follows along the curve; −1: no crossing
  std::vector<int> contour_of_;
  std::vector<Contour> contours_;
};

}  // namespace

std::vector<Contour> trace_contours(const Image<float>& phi, const Eigen::Vector2d& spacing_mm) {
  if (phi.size() == 0) return {};
  return Tracer(phi, spacing_mm).run();
}

bool touches_border(const Image<float>& phi) {
  if (phi.size() == 0) return false;
  const Eigen::Index last_row = phi.rows() - 1, last_column = phi.cols() - 1;
  return (phi.row(0) >= 0).any() || (phi.row(last_row) >= 0).any() || (phi.col(0) >= 0).any() ||
         (phi.col(last_column) >= 0).any();
}

bool touches_border(const ContourSlice& slice) {
  if (slice.size_pixels.minCoeff() <= 0) return false;
  const Eigen::Vector2d last = (slice.size_pixels.array() - 1).cast<double>();
  constexpr double beyond = 0.25;  // crossings lie within the pixel centres or half a pixel beyond them
  for (const Contour& contour : slice.contours)
    for (const Eigen::Vector2d& point_mm : contour.points_mm) {
      const Eigen::Vector2d pixel = slice.pose.slice_to_pixel(point_mm);
      if (pixel.minCoeff() < -beyond || (pixel - last).maxCoeff() > beyond) return true;
    }
  return false;
}

}  // namespace isostack
