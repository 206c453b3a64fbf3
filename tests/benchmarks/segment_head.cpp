// segment_head MATRIX slices|volume THREADS RMS [RIVAL_REGION]: bone by the level set of rival_itk_level_set: the same
// equation (threshold range in HU, curvature 0.5), start, bound on the RMS movement and on the steps. ITK keeps three
// layers on either side of the curve, isostack two; its result is a distance as wide as contours need.
// RIVAL_REGION: the bytes that program wrote; the Dice coefficient with them is printed.
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "segmentation/level_set.h"
#include "tests/benchmarks/head_ct.h"

namespace {

using namespace isostack;
using benchmarks::HeadCt;

/// Segments count/… voxels from `first` on; returns the steps.
template <int D>
int segment_part(const HeadCt& head, std::size_t first, const std::array<int, D>& size, double rms,
                 std::vector<std::uint8_t>& region) {
  Field<D> image;
  image.size = size;
  std::copy_n(HeadCt::spacing_mm, D, image.spacing_mm.begin());
  std::size_t count = 1;
  for (const int n : size) count *= static_cast<std::size_t>(n);
  image.values.resize(count);
  Field<D> start = image;
  for (std::size_t i = 0; i < count; ++i) {
    image.values[i] = head.voxels[first + i];
    start.values[i] = HeadCt::is_bone(image.values[i]) ? 0.5f : -0.5f;
  }
  ThresholdRangeTerm<D> range(std::move(image), HeadCt::lower, HeadCt::upper);
  CurvatureTerm<D> curvature(HeadCt::curvature);
  LevelSetOptions options;
  options.max_steps = HeadCt::max_steps;
  options.tolerance_pixels = rms;
  options.band_pixels = narrow_band_pixels<D>;
  const double hounsfield = (HeadCt::upper - HeadCt::lower) / 2;
  const auto result = evolve<D>(std::move(start), {{&range, hounsfield}, &curvature}, options);
  for (std::size_t i = 0; i < count; ++i) region[first + i] = result.phi.values[i] >= 0;
  return result.steps;
}

double dice_with(const char* path, const std::vector<std::uint8_t>& region) {
  std::vector<std::uint8_t> rival(region.size());
  std::ifstream(path, std::ios::binary)
      .read(reinterpret_cast<char*>(rival.data()), static_cast<std::streamsize>(rival.size()));
  double both = 0, sum = 0;
  for (std::size_t i = 0; i < region.size(); ++i) {
    both += region[i] && rival[i];
    sum += region[i] + rival[i];
  }
  return 2 * both / sum;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return 2;
  const auto head = benchmarks::read_head_ct(argv[1]);
  if (head.voxels.empty()) return 3;
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(std::max(1, std::atoi(argv[3]))));
  const double rms = std::atof(argv[4]);
  std::vector<std::uint8_t> region(head.voxels.size());
  std::atomic<int> steps = 0;
  const Stopwatch watch;
  if (std::strcmp(argv[2], "volume") == 0)
    steps = segment_part<3>(head, 0, {HeadCt::columns, HeadCt::rows, HeadCt::slices}, rms, region);
  else
    tbb::parallel_for(0, HeadCt::slices, [&](int k) {
      const std::size_t first = static_cast<std::size_t>(k) * HeadCt::slice_size;
      steps += segment_part<2>(head, first, {HeadCt::columns, HeadCt::rows}, rms, region);
    });
  std::printf("seconds %.3f\nsteps %d\npeak_gb %.2f\n", watch.seconds(), steps.load(),
              static_cast<double>(peak_memory_bytes()) / 1e9);
  if (argc > 5) std::printf("dice %.4f\n", dice_with(argv[5], region));
  return 0;
}
