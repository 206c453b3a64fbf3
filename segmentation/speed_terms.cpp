#include "segmentation/speed_terms.h"

#include <algorithm>
#include <cmath>

#include "segmentation/derivatives.h"

namespace isostack {

template <int D>
IsosurfaceTerm<D>::IsosurfaceTerm(const Field<D>& image, double level, double width_mm, double gradient_floor)
    : speed_(image.values.size()) {
  std::vector<double> slope(image.values.size());  // |∇I|
  double steepest = 0;
  for (std::size_t node = 0; node < slope.size(); ++node) {
    slope[node] = derivatives_at(image, node).gradient().norm();
    steepest = std::max(steepest, slope[node]);
  }
  for (std::size_t node = 0; node < slope.size(); ++node) {
    const double height = image.values[node] - level;
    const double run = std::max(slope[node], gradient_floor * steepest) * width_mm;
    // α/√(1 + α²) with α = height/run, defined also in an image without any slope.
    speed_[node] = height == 0 ? 0 : height / std::hypot(height, run);
  }
}

template class IsosurfaceTerm<2>;
template class IsosurfaceTerm<3>;

}  // namespace isostack
