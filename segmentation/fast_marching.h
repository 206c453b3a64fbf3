#pragma once

#include <cstddef>
#include <vector>

#include "segmentation/field.h"

namespace isostack {

/// Turns phi (inside where phi >= 0, any scale) into the signed distance in mm to its zero set, positive
/// inside, up to `band_mm`; farther nodes get ±band_mm. Without a zero set every node gets ±band_mm.
///
/// Next to the zero set the distance is that of distance_beside_curve. From there |∇φ| = 1 (Breen et al. 2001, eq. 7)
/// is solved outwards by Sethian's fast marching method with second-order upwind differences where two known values
/// lie in a row; nodes are taken in order of distance up to a tenth of a pixel, both sides of the curve at the same
/// time. Spacings may differ between axes. One byte per node besides phi. The result is the same on any number of
/// threads.
template <int D>
void redistance(Field<D>& phi, double band_mm);

/// The same where the nodes beside the zero set are known, in any order.
template <int D>
void redistance(Field<D>& phi, double band_mm, const std::vector<std::size_t>& beside_curve);

extern template void redistance(Field<2>&, double);
extern template void redistance(Field<3>&, double);
extern template void redistance(Field<2>&, double, const std::vector<std::size_t>&);
extern template void redistance(Field<3>&, double, const std::vector<std::size_t>&);

}  // namespace isostack
