#pragma once

#include "segmentation/speed_terms.h"

namespace isostack {

struct EdgeOptions {
  double contrast = 1;   ///< |∇I| in grey values per mm at which g = 1/2; edges are clearly steeper
  double length_mm = 1;  ///< ℓ: weight of the geodesic terms, they have the unit 1/mm by themselves
  double balloon = 0;    ///< c: > 0 grows, < 0 shrinks until an edge stops it
};

/// F = ℓ (g ∇·(∇φ/|∇φ|) + ∇g·∇φ/|∇φ|) + c g with g = 1/(1 + (|∇I|/contrast)²): geodesic active contours (Caselles,
/// Kimmel and Sapiro 1997). The curve becomes the shortest where lengths are weighted by g: it
/// rests in the valleys of g, which are the edges of the image. The advection draws it there from up to an edge's
/// width; the balloon brings it there from afar.
template <int D>
class EdgeTerm : public SpeedTerm<D> {
 public:
  using Vector = typename SpeedTerm<D>::Vector;

  /// `image` lies on the lattice of φ and has been filtered against noise (Gaussian of one or two pixels).
  /// Throws InputError unless contrast > 0 and length_mm >= 0.
  EdgeTerm(SharedField<D> image, const EdgeOptions& options);
  bool is_constant_in_time() const override { return true; }
  double propagation(std::size_t node) const override { return options_.balloon * stopping(node); }
  double curvature_weight_mm(std::size_t node) const override { return options_.length_mm * stopping(node); }
  Vector advection(std::size_t node) const override;
  bool has_advection() const override { return options_.length_mm > 0; }

 private:
  double stopping(std::size_t node) const;  ///< g

  SharedField<D> image_;
  EdgeOptions options_;
};

extern template class EdgeTerm<2>;
extern template class EdgeTerm<3>;

}  // namespace isostack
