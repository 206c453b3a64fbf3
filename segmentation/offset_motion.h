#pragma once

#include "segmentation/field.h"

namespace isostack {

/// Motion along the normal, φ_t = ±|∇φ| (Breen et al. 2001, eq. 9), up to the time |distance_mm|: the region
/// (phi >= 0, any scale) grows by a positive distance, shrinks by a negative one. Its solution is the offset of the
/// signed distance, which fast marching gives to second order without time steps. Returns the signed distance
/// to the new curve in mm up to `band_mm`. The border of the lattice does not count as an edge of the region.
template <int D>
Field<D> offset_region(Field<D> phi, double distance_mm, double band_mm);

/// O_a φ = D_a E_a φ: removes what is nowhere 2a wide, rounds convex corners to radius a.
template <int D>
Field<D> open_region(Field<D> phi, double radius_mm, double band_mm);

/// C_a φ = E_a D_a φ: closes gaps and holes narrower than 2a.
template <int D>
Field<D> close_region(Field<D> phi, double radius_mm, double band_mm);

extern template Field<2> offset_region(Field<2>, double, double);
extern template Field<3> offset_region(Field<3>, double, double);
extern template Field<2> open_region(Field<2>, double, double);
extern template Field<3> open_region(Field<3>, double, double);
extern template Field<2> close_region(Field<2>, double, double);
extern template Field<3> close_region(Field<3>, double, double);

}  // namespace isostack
