#include "recon/metrics/input_sections.h"

#include <oneapi/tbb/parallel_for.h>

#include <vector>

#include "recon/geometry/pixel_lattice.h"
#include "recon/surface/plane_section.h"

namespace isostack {

SliceAgreement agreement_at_inputs(const TriangleMesh& surface, const ContourStack& contours) {
  std::vector<std::vector<Contour>> sections(contours.slices.size());
  tbb::parallel_for(std::size_t{0}, contours.slices.size(),
                    [&](std::size_t i) { sections[i] = plane_section(surface, contours.slices[i].pose); });
  SliceComparison comparison;
  for (std::size_t i = 0; i < contours.slices.size(); ++i) {
    const ContourSlice& slice = contours.slices[i];
    const PixelLattice lattice = lattice_of(slice, contours);
    comparison.add(moved_to(lattice.pose, sections[i], slice.pose), moved_to(lattice.pose, slice.contours, slice.pose),
                   lattice);
  }
  return comparison.agreement();
}

}  // namespace isostack
