#include "segmentation/speed_terms.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "recon/geometry/errors.h"
#include "segmentation/derivatives.h"
#include "segmentation/pieces.h"

namespace isostack {

namespace {

template <int D>
double steepest_slope(const Field<D>& image) {
  const Pieces pieces{image.values.size(), 1 << 18};
  std::vector<double> steepest(pieces.number());
  pieces.for_each([&](std::size_t piece, std::size_t first, std::size_t last) {
    double squared = 0;
    for (std::size_t node = first; node < last; ++node)
      squared = std::max(squared, gradient_at(image, node).squaredNorm());
    steepest[piece] = std::sqrt(squared);
  });
  return steepest.empty() ? 0 : *std::max_element(steepest.begin(), steepest.end());
}

}  // namespace

template <int D>
IsosurfaceTerm<D>::IsosurfaceTerm(SharedField<D> image, double level, double width_mm, double gradient_floor)
    : image_(std::move(image)),
      level_(level),
      width_mm_(width_mm),
      least_slope_(gradient_floor * steepest_slope<D>(*image_)) {}

template <int D>
double IsosurfaceTerm<D>::propagation(std::size_t node) const {
  const double height = image_->values[node] - level_;
  const double run = std::max(gradient_at(*image_, node).norm(), least_slope_) * width_mm_;
  // α/√(1 + α²) with α = height/run, defined also in an image without any slope.
  return height == 0 ? 0 : height / std::hypot(height, run);
}

template <int D>
ThresholdRangeTerm<D>::ThresholdRangeTerm(SharedField<D> image, double lower, double upper, double scale)
    : image_(std::move(image)), lower_(lower), upper_(upper), scale_(scale > 0 ? scale : (upper - lower) / 2) {
  if (!std::isfinite(lower) || !std::isfinite(upper) || !(lower < upper))
    throw InputError("threshold range", "its lower limit is not below its upper one", "give two grey values in order");
  if (!(scale >= 0) || !std::isfinite(scale_))
    throw InputError("threshold range", "the scale of the speed is negative or not a number", "give 0 or more");
}

template <int D>
double ThresholdRangeTerm<D>::propagation(std::size_t node) const {
  const double grey = image_->values[node];
  return std::clamp(std::min(grey - lower_, upper_ - grey) / scale_, -1.0, 1.0);
}

template class IsosurfaceTerm<2>;
template class IsosurfaceTerm<3>;
template class ThresholdRangeTerm<2>;
template class ThresholdRangeTerm<3>;

}  // namespace isostack
