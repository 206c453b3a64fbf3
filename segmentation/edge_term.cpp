#include "segmentation/edge_term.h"

#include <cmath>
#include <utility>

#include "recon/geometry/errors.h"
#include "segmentation/derivatives.h"
#include "segmentation/lattice.h"

namespace isostack {

template <int D>
EdgeTerm<D>::EdgeTerm(SharedField<D> image, const EdgeOptions& options) : image_(std::move(image)), options_(options) {
  if (!(options.contrast > 0) || !std::isfinite(options.contrast))
    throw InputError("edge term", "the contrast of an edge is not above 0", "give grey values per mm");
  if (!(options.length_mm >= 0) || !std::isfinite(options.length_mm) || !std::isfinite(options.balloon))
    throw InputError("edge term", "a weight is negative or not a number", "give a length in mm of 0 or more");
}

template <int D>
double EdgeTerm<D>::stopping(std::size_t node) const {
  return 1 / (1 + gradient_at(*image_, node).squaredNorm() / (options_.contrast * options_.contrast));
}

template <int D>
typename EdgeTerm<D>::Vector EdgeTerm<D>::advection(std::size_t node) const {
  const Lattice<D> lattice(*image_);
  const auto sides = lattice.sides_of(node);
  const double here = stopping(node);
  Vector slope = Vector::Zero();
  for (int axis = 0; axis < D; ++axis) {
    const bool has_before = sides & lattice.before(axis), has_after = sides & lattice.after(axis);
    if (!has_before && !has_after) continue;
    const double before = has_before ? stopping(lattice.moved(node, -lattice.stride[axis])) : here;
    const double after = has_after ? stopping(lattice.moved(node, lattice.stride[axis])) : here;
    slope[axis] = (after - before) / ((has_before + has_after) * lattice.spacing_mm[axis]);
  }
  return options_.length_mm * slope;
}

template class EdgeTerm<2>;
template class EdgeTerm<3>;

}  // namespace isostack
