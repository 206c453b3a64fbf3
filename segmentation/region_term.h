#pragma once

#include "segmentation/speed_terms.h"

namespace isostack {

struct RegionOptions {
  /// Means are taken within this distance along every axis (a square or cube) of the node; 0: over the whole lattice.
  double window_mm = 0;
};

/// F = ((I − c_out)² − (I − c_in)²)/(c_in − c_out)² = 2 (I − (c_in + c_out)/2)/(c_in − c_out), within [−1, 1]: Chan and
/// Vese 2001 with λ1 = λ2, made free of grey units. c_in and c_out are the mean grey values inside and outside
/// the curve as it is: the curve goes outwards where I is nearer to c_in. With a window they are means of the curve's
/// neighbourhood (Lankton and Tannenbaum 2008), which withstands a bias field. F = 0 where both means are equal or
/// one side is empty.
template <int D>
class RegionTerm : public SpeedTerm<D> {
 public:
  /// `image` lies on the lattice of φ.
  explicit RegionTerm(SharedField<D> image, const RegionOptions& options = {});
  void start(const Field<D>& phi) override;
  void changed_side(std::size_t node, bool is_inside_now) override;
  double propagation(std::size_t node) const override;

 private:
  /// Sums of the grey values outside (0) and inside (1).
  struct Sums {
    double grey[2] = {0, 0}, count[2] = {0, 0};
  };
  Sums sums_around(std::size_t node) const;

  SharedField<D> image_;
  RegionOptions options_;
  const Field<D>* phi_ = nullptr;  ///< of the evolution at hand
  Sums whole_;
};

extern template class RegionTerm<2>;
extern template class RegionTerm<3>;

}  // namespace isostack
