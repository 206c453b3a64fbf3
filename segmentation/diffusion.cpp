#include "segmentation/diffusion.h"

namespace isostack {

namespace {

/// Flux from every pixel to its neighbour, times the time step; `rate` = h_min²/h² along the pair.
Image<float> flux(const Image<float>& to, const Image<float>& from, float contrast, float rate, float step) {
  const Image<float> difference = to - from;
  return step * rate * difference / (1 + rate * (difference / contrast).square());
}

}  // namespace

Image<float> anisotropic_diffusion(const Image<float>& image, const Eigen::Vector2d& spacing_mm,
                                   const DiffusionOptions& options) {
  const Eigen::Index rows = image.rows(), columns = image.cols();
  const Eigen::Vector2d rate = (spacing_mm.minCoeff() / spacing_mm.array()).square();
  const auto rate_x = static_cast<float>(rate.x()), rate_y = static_cast<float>(rate.y());
  const auto step = static_cast<float>(0.5 / rate.sum());
  const auto contrast = static_cast<float>(options.contrast);
  Image<float> result = image;
  for (int i = 0; i < options.steps; ++i) {
    const Image<float> right =
        columns > 1 ? flux(result.rightCols(columns - 1), result.leftCols(columns - 1), contrast, rate_x, step)
                    : Image<float>(rows, 0);
    const Image<float> down = rows > 1
                                  ? flux(result.bottomRows(rows - 1), result.topRows(rows - 1), contrast, rate_y, step)
                                  : Image<float>(0, columns);
    if (columns > 1) {
      result.leftCols(columns - 1) += right;
      result.rightCols(columns - 1) -= right;
    }
    if (rows > 1) {
      result.topRows(rows - 1) += down;
      result.bottomRows(rows - 1) -= down;
    }
  }
  return result;
}

}  // namespace isostack
