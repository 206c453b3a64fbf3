#include <gtest/gtest.h>

#include "recon/metrics/frame_quality.h"
#include "recon/morphing/variational_morph.h"
#include "tests/support/figures.h"

namespace isostack {
namespace {

using testing_support::contours_of;
using testing_support::disc;
using testing_support::largest_distance;
using testing_support::o_figure;
using testing_support::x_figure;

const VariationalMorphOptions corners{.layout = KeyLayout::simplex, .max_constraints = 3000};

std::vector<KeyShape> three_shapes() { return {x_figure(), o_figure(), disc("disc", {50, 50}, 15)}; }

TEST(InfluenceShapes, AllCornersAreReproduced) {
  const std::vector<KeyShape> shapes = three_shapes();
  const Morph morph = variational_morph(shapes, corners);
  for (Eigen::Index i = 0; i < 3; ++i)
    EXPECT_LT(largest_distance(contours_of(morph.at(Eigen::Vector3d::Unit(i))),
                               contours_of(shapes[static_cast<std::size_t>(i)].shape)),
              0.1);
}

TEST(InfluenceShapes, ThePathThroughOneTakesOnItsCharacter) {
  const Morph morph = variational_morph(three_shapes(), corners);
  const FrameQuality straight = frame_quality(morph.at(Eigen::Vector3d(0.5, 0.5, 0)));
  const FrameQuality influenced = frame_quality(morph.at(Eigen::Vector3d(0.2, 0.2, 0.6)));
  EXPECT_LT(influenced.content, straight.content / 2);  // the disc has a fifth of their area
  EXPECT_EQ(influenced.holes, 0u);
}

TEST(InfluenceShapes, TheirOrderDoesNotMatter) {
  const std::vector<KeyShape> shapes = three_shapes();
  const Morph one = variational_morph(shapes, corners);
  const Morph other = variational_morph({shapes[2], shapes[0], shapes[1]}, corners);
  EXPECT_LT(largest_distance(contours_of(one.at(Eigen::Vector3d(0.5, 0.2, 0.3))),
                             contours_of(other.at(Eigen::Vector3d(0.3, 0.5, 0.2)))),
            0.02);  // two traced curves, each within a hundredth of a pixel
}

TEST(InfluenceShapes, MayLieAtGivenPlaces) {
  std::vector<KeyShape> shapes = three_shapes();  // the paper's §7
  shapes[0].place = Eigen::Vector2d(0, 0);
  shapes[1].place = Eigen::Vector2d(1, 0);
  shapes[2].place = Eigen::Vector2d(0.5, 0.5);
  VariationalMorphOptions options = corners;
  options.layout = KeyLayout::given;
  const Morph morph = variational_morph(shapes, options);
  EXPECT_LT(largest_distance(contours_of(morph.at(Eigen::Vector3d(0, 0, 1))), contours_of(shapes[2].shape)), 0.1);
  EXPECT_FALSE(morph.spacetime().has_value());
}

}  // namespace
}  // namespace isostack
