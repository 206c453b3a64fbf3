// Bone in slices of a CT of a head, beside a plain solver on every node. Needs Debian's invesalius-examples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "segmentation/derivatives.h"
#include "segmentation/fast_marching.h"
#include "segmentation/level_set.h"
#include "tests/benchmarks/head_ct.h"

namespace isostack {
namespace {

using benchmarks::HeadCt;

HeadCt head_ct() {
  const std::string archive = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
  if (!std::filesystem::exists(archive)) return {};
  const std::string matrix = testing::TempDir() + "isostack_level_set_head";
  const std::string command = "tar -xOf " + archive + " --wildcards '*/matrix.dat' >'" + matrix + "'";
  if (std::system(command.c_str()) != 0) return {};
  HeadCt head = benchmarks::read_head_ct(matrix);
  std::filesystem::remove(matrix);
  return head;
}

/// φ_t = |∇φ| F at every node by Godunov's scheme and explicit steps, φ made a distance again after each.
Field<2> plain_flow(Field<2> phi, const SpeedTerm<2>& range, double weight, double time_mm) {
  const double step_mm = 0.4 * phi.smallest_spacing_mm() / weight;  // |range| ≤ 1
  for (double left_mm = time_mm; left_mm > 0; left_mm -= step_mm) {
    redistance(phi, 6 * phi.smallest_spacing_mm());
    const Field<2> before = phi;
    for (std::size_t node = 0; node < phi.values.size(); ++node) {
      const auto derivatives = derivatives_at(before, node);
      const double speed = weight * range.propagation(node);
      const double bend = std::clamp(derivatives.curvature_motion(), -1.0, 1.0);
      const double rate = speed * derivatives.upwind_gradient_norm(speed > 0) + HeadCt::curvature * bend;
      phi.values[node] += static_cast<float>(std::min(step_mm, left_mm) * rate);
    }
  }
  return phi;
}

TEST(LevelSetHead, BoneIsThatOfAPlainSolver) {
  const HeadCt head = head_ct();
  if (head.voxels.empty()) GTEST_SKIP() << "install invesalius-examples for the head";
  for (const std::size_t slice : {20, 50, 80}) {
    Field<2> image{{HeadCt::columns, HeadCt::rows}, {HeadCt::spacing_mm[0], HeadCt::spacing_mm[1]}, {}};
    const auto first = head.voxels.begin() + static_cast<std::ptrdiff_t>(slice * HeadCt::slice_size);
    image.values.assign(first, first + static_cast<std::ptrdiff_t>(HeadCt::slice_size));
    Field<2> start = image;
    for (float& value : start.values) value = HeadCt::is_bone(value) ? 0.5f : -0.5f;
    ThresholdRangeTerm<2> range(image, HeadCt::lower, HeadCt::upper);
    CurvatureTerm<2> curvature(HeadCt::curvature);
    const double weight = (HeadCt::upper - HeadCt::lower) / 2;
    LevelSetOptions options;
    options.tolerance_pixels = 0.01;
    options.band_pixels = narrow_band_pixels<2>;
    const auto result = evolve<2>(start, {{&range, weight}, &curvature}, options);
    EXPECT_EQ(result.stop, LevelSetStop::converged);
    const Field<2> plain = plain_flow(start, range, weight, result.time_mm);
    double both = 0, sum = 0;
    for (std::size_t node = 0; node < HeadCt::slice_size; ++node) {
      const bool mine = result.phi.values[node] >= 0, other = plain.values[node] >= 0;
      both += mine && other;
      sum += mine + other;
    }
    ASSERT_GT(sum, 1000);
    EXPECT_GE(2 * both / sum, 0.99) << "slice " << slice;
  }
}

}  // namespace
}  // namespace isostack
