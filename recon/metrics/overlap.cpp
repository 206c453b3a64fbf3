#include "recon/metrics/overlap.h"

#include "recon/geometry/errors.h"

namespace isostack {

Overlap overlap(const LabelVolume& a, const LabelVolume& b) {
  if (a.grid.size != b.grid.size)
    throw InputError("overlap", "the two volumes have different sizes", "put both on one grid with --grid");
  std::size_t in_a = 0, in_b = 0, in_both = 0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i) {
    in_a += a.voxels[i] != 0;
    in_b += b.voxels[i] != 0;
    in_both += a.voxels[i] != 0 && b.voxels[i] != 0;
  }
  Overlap result;
  if (in_a + in_b > 0)
    result.dice = 2.0 * static_cast<double>(in_both) / static_cast<double>(in_a + in_b);
  else
    result.dice = 1;
  result.volume_a_mm3 = static_cast<double>(in_a) * a.grid.voxel_volume_mm3();
  result.volume_b_mm3 = static_cast<double>(in_b) * b.grid.voxel_volume_mm3();
  return result;
}

}  // namespace isostack
