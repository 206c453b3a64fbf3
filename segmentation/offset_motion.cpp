#include "segmentation/offset_motion.h"

#include <cmath>
#include <utility>

#include "segmentation/fast_marching.h"

namespace isostack {

template <int D>
Field<D> offset_region(Field<D> phi, double distance_mm, double band_mm) {
  // Two pixels more, so that the new curve has neighbours on both sides.
  redistance(phi, std::abs(distance_mm) + 2 * phi.smallest_spacing_mm());
  for (float& value : phi.values) value += static_cast<float>(distance_mm);
  redistance(phi, band_mm);
  return phi;
}

template <int D>
Field<D> open_region(Field<D> phi, double radius_mm, double band_mm) {
  const double near_mm = 2 * phi.smallest_spacing_mm();
  return offset_region(offset_region(std::move(phi), -radius_mm, radius_mm + near_mm), radius_mm, band_mm);
}

template <int D>
Field<D> close_region(Field<D> phi, double radius_mm, double band_mm) {
  const double near_mm = 2 * phi.smallest_spacing_mm();
  return offset_region(offset_region(std::move(phi), radius_mm, radius_mm + near_mm), -radius_mm, band_mm);
}

template Field<2> offset_region(Field<2>, double, double);
template Field<3> offset_region(Field<3>, double, double);
template Field<2> open_region(Field<2>, double, double);
template Field<3> open_region(Field<3>, double, double);
template Field<2> close_region(Field<2>, double, double);
template Field<3> close_region(Field<3>, double, double);

}  // namespace isostack
