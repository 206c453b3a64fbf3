#pragma once

#include "segmentation/field.h"

namespace isostack {

/// Turns phi (inside where phi >= 0, any scale) into the signed distance in mm to its zero set, positive
/// inside, up to `band_mm`; farther nodes get ±band_mm. Without a zero set every node gets ±band_mm.
///
/// Next to the zero set the distance comes from the second-order expansion of phi along its normal where phi is
/// smooth at the scale of a pixel (its zero set may then differ by O(h³) from the linear crossings), else from the
/// crossings on the lattice lines, 1/d² = Σ 1/d_i². From there |∇φ| = 1 (Breen et al. 2001, eq. 7) is solved outwards
/// by Sethian's fast marching method with second-order upwind differences where two known values lie in a row. Spacings
/// may differ between axes.
template <int D>
void redistance(Field<D>& phi, double band_mm);

extern template void redistance(Field<2>&, double);
extern template void redistance(Field<3>&, double);

}  // namespace isostack
