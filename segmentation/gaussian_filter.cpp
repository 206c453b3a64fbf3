#include "segmentation/gaussian_filter.h"

#include <algorithm>
#include <cmath>

namespace isostack {

namespace {

/// Weights at offsets −radius..radius; four sigmas keep the cut-off tail below 1e-4.
Eigen::ArrayXf kernel_of(double sigma_pixels) {
  const int radius = std::max(1, static_cast<int>(std::ceil(4 * sigma_pixels)));
  Eigen::ArrayXd weights(2 * radius + 1);
  for (int i = -radius; i <= radius; ++i) weights[i + radius] = std::exp(-0.5 * std::pow(i / sigma_pixels, 2));
  return (weights / weights.sum()).cast<float>();
}

Image<float> filter_rows(const Image<float>& image, double sigma_pixels) {
  const Eigen::ArrayXf kernel = kernel_of(sigma_pixels);
  const Eigen::Index radius = kernel.size() / 2;
  Image<float> result = Image<float>::Zero(image.rows(), image.cols());
  for (Eigen::Index row = 0; row < image.rows(); ++row)
    for (Eigen::Index offset = -radius; offset <= radius; ++offset) {
      const Eigen::Index source = std::clamp<Eigen::Index>(row + offset, 0, image.rows() - 1);
      result.row(row) += kernel[offset + radius] * image.row(source);
    }
  return result;
}

Image<float> filter_columns(const Image<float>& image, double sigma_pixels) {
  const Eigen::ArrayXf kernel = kernel_of(sigma_pixels);
  const Eigen::Index radius = kernel.size() / 2, columns = image.cols();
  Image<float> result(image.rows(), columns);
  Eigen::ArrayXf padded(columns + 2 * radius);
  for (Eigen::Index row = 0; row < image.rows(); ++row) {
    padded.head(radius) = image(row, 0);
    padded.segment(radius, columns) = image.row(row);
    padded.tail(radius) = image(row, columns - 1);
    for (Eigen::Index column = 0; column < columns; ++column)
      result(row, column) = (padded.segment(column, kernel.size()) * kernel).sum();
  }
  return result;
}

}  // namespace

Image<float> gaussian_filter(const Image<float>& image, const Eigen::Vector2d& sigma_pixels) {
  if (image.size() == 0) return image;
  Image<float> result = sigma_pixels.x() > 0 ? filter_columns(image, sigma_pixels.x()) : image;
  return sigma_pixels.y() > 0 ? filter_rows(result, sigma_pixels.y()) : result;
}

Image<float> gaussian_filter_mm(const Image<float>& image, double sigma_mm, const Eigen::Vector2d& spacing_mm) {
  return gaussian_filter(image, Eigen::Vector2d::Constant(sigma_mm).cwiseQuotient(spacing_mm));
}

}  // namespace isostack
