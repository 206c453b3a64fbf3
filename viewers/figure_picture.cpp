#include "viewers/figure_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr double margin = 0.06;  ///< of the longer side, on every side

/// Lines per row of pixels along which the covered length is exact.
constexpr int lines_per_row = 16;

/// Where the contours' edges meet each line, in pixels from the left.
std::vector<std::vector<double>> crossings_of(const std::vector<Contour>& contours, const PictureFrame& frame) {
  const int lines = frame.height_pixels() * lines_per_row;
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(lines));
  const auto in_picture = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return (p - frame.box_mm.min()) * frame.pixels_per_mm;
  };
  for (const Contour& contour : contours)
    for (std::size_t i = 0; i < contour.points_mm.size(); ++i) {
      Eigen::Vector2d a = in_picture(contour.points_mm[i]);
      Eigen::Vector2d b = in_picture(contour.points_mm[(i + 1) % contour.points_mm.size()]);
      if (a.y() > b.y()) std::swap(a, b);
      // Line k runs at the height (k + 1/2) / lines_per_row; an edge owns its upper end and not its lower one.
      const double first = std::ceil(a.y() * lines_per_row - 0.5), end = std::ceil(b.y() * lines_per_row - 0.5);
      for (int k = static_cast<int>(std::max(first, 0.0)); k < std::min<double>(end, lines); ++k) {
        const double y = (k + 0.5) / lines_per_row;
        crossings[static_cast<std::size_t>(k)].push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
      }
    }
  return crossings;
}

/// Adds to each pixel of a row the length of [from, to] that lies in it.
void cover(double from, double to, std::vector<double>& row) {
  const auto width = static_cast<double>(row.size());
  from = std::clamp(from, 0.0, width);
  to = std::clamp(to, 0.0, width);
  for (auto x = static_cast<std::size_t>(from); static_cast<double>(x) < to; ++x)
    row[x] += std::min(to, static_cast<double>(x + 1)) - std::max(from, static_cast<double>(x));
}

std::array<std::uint8_t, 3> mixed(const FigureLook& look, double fill) {
  const auto channel = [fill](std::uint8_t ground, std::uint8_t ink) {
    return static_cast<std::uint8_t>(std::lround(ground + fill * (ink - ground)));
  };
  return {channel(look.ground.red, look.fill.red), channel(look.ground.green, look.fill.green),
          channel(look.ground.blue, look.fill.blue)};
}

}  // namespace

int PictureFrame::width_pixels() const {
  return std::max(1, static_cast<int>(std::lround(box_mm.sizes().x() * pixels_per_mm)));
}

int PictureFrame::height_pixels() const {
  return std::max(1, static_cast<int>(std::lround(box_mm.sizes().y() * pixels_per_mm)));
}

PictureFrame frame_round(const std::vector<std::vector<Contour>>& figures, int longer_side_pixels) {
  if (longer_side_pixels < 16 || longer_side_pixels > 8000)
    throw InputError("picture", "its size is out of range", "ask for 16 to 8000 pixels a side");
  Eigen::AlignedBox2d box;
  for (const std::vector<Contour>& contours : figures)
    for (const Contour& contour : contours)
      for (const Eigen::Vector2d& point : contour.points_mm) {
        if (!point.allFinite()) throw InputError("picture", "a contour has a point that is not finite", "leave it out");
        box.extend(point);
      }
  if (box.isEmpty()) throw InputError("picture", "there is no contour to draw", "give at least one");
  const double side_mm = std::max(box.sizes().maxCoeff(), 1e-6);
  box.extend(box.min() - Eigen::Vector2d::Constant(margin * side_mm));
  box.extend(box.max() + Eigen::Vector2d::Constant(margin * side_mm));
  return {.box_mm = box, .pixels_per_mm = longer_side_pixels / box.sizes().maxCoeff()};
}

Picture draw_figure(const std::vector<Contour>& contours, const PictureFrame& frame, const FigureLook& look) {
  Picture picture{.width_pixels = frame.width_pixels(), .height_pixels = frame.height_pixels(), .rgb = {}};
  picture.rgb.reserve(std::size_t{3} * static_cast<std::size_t>(picture.width_pixels) *
                      static_cast<std::size_t>(picture.height_pixels));
  std::vector<std::vector<double>> crossings = crossings_of(contours, frame);
  std::vector<double> row(static_cast<std::size_t>(picture.width_pixels));
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height_pixels); ++y) {
    std::fill(row.begin(), row.end(), 0.0);
    for (std::size_t line = y * lines_per_row; line < (y + 1) * lines_per_row; ++line) {
      std::sort(crossings[line].begin(), crossings[line].end());
      for (std::size_t i = 0; i + 1 < crossings[line].size(); i += 2)
        cover(crossings[line][i], crossings[line][i + 1], row);
    }
    for (const double covered : row) {
      const auto rgb = mixed(look, std::min(covered / lines_per_row, 1.0));
      picture.rgb.insert(picture.rgb.end(), rgb.begin(), rgb.end());
    }
  }
  return picture;
}

}  // namespace isostack
