#include "recon/morphing/key_places.h"

#include <gtest/gtest.h>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

std::vector<KeyShape> at_times(const std::vector<double>& times) {
  std::vector<KeyShape> shapes;
  for (const double time : times) {
    shapes.emplace_back();
    shapes.back().time = time;
  }
  return shapes;
}

std::vector<KeyShape> untimed(std::size_t count) {
  std::vector<KeyShape> shapes;
  while (shapes.size() < count) shapes.emplace_back();
  return shapes;
}

TEST(KeyPlaces, UntimedShapesAreEvenAndAUnitApart) {
  const KeyPlaces places = key_places(untimed(4), KeyLayout::line);
  EXPECT_TRUE(places.coordinates.isApprox(Eigen::RowVector4d(0, 1, 2, 3)));
}

TEST(KeyPlaces, TimesKeepTheirRatiosAtAMeanDistanceOfOne) {
  const KeyPlaces places = key_places(at_times({10, 40, 50}), KeyLayout::line);
  EXPECT_TRUE(places.coordinates.isApprox(Eigen::RowVector3d(0, 1.5, 2)));
}

TEST(KeyPlaces, TimeRunsThroughAllKeyShapesOfALine) {
  const KeyPlaces places = key_places(at_times({10, 40, 50}), KeyLayout::line);
  EXPECT_TRUE(places.weights_at(0).isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_TRUE(places.weights_at(0.75).isApprox(Eigen::Vector3d(0, 1, 0)));
  EXPECT_TRUE(places.weights_at(0.375).isApprox(Eigen::Vector3d(0.5, 0.5, 0)));
  EXPECT_TRUE(places.weights_at(1).isApprox(Eigen::Vector3d(0, 0, 1)));
  EXPECT_THROW(places.weights_at(1.01), InputError);
}

TEST(KeyPlaces, CornersOfASimplexAreAllOneApart) {
  for (std::size_t count = 2; count <= 5; ++count) {
    const KeyPlaces places = key_places(untimed(count), KeyLayout::simplex);
    EXPECT_EQ(places.coordinates.rows(), static_cast<Eigen::Index>(count) - 1);
    for (Eigen::Index i = 0; i < places.key_count(); ++i)
      for (Eigen::Index j = 0; j < i; ++j)
        EXPECT_NEAR((places.coordinates.col(i) - places.coordinates.col(j)).norm(), 1, 1e-12);
  }
}

TEST(KeyPlaces, GivenPlacesAreKept) {
  std::vector<KeyShape> shapes(3);  // the paper's §7
  shapes[0].place = Eigen::Vector2d(0, 0);
  shapes[1].place = Eigen::Vector2d(1, 0);
  shapes[2].place = Eigen::Vector2d(0.5, 0.5);
  const KeyPlaces places = key_places(shapes, KeyLayout::given);
  EXPECT_TRUE(places.place_at(Eigen::Vector3d(0.25, 0.25, 0.5)).isApprox(Eigen::Vector2d(0.5, 0.25)));
  shapes[2].place = Eigen::Vector3d(0, 0, 1);
  EXPECT_THROW(key_places(shapes, KeyLayout::given), InputError);
  shapes[2].place = shapes[1].place;
  EXPECT_THROW(key_places(shapes, KeyLayout::given), InputError);
}

TEST(KeyPlaces, TimesMustAscendAndBeThereForAll) {
  EXPECT_THROW(key_places(at_times({0, 2, 2}), KeyLayout::line), InputError);
  std::vector<KeyShape> shapes = at_times({0, 1, 2});
  shapes[1].time.reset();
  EXPECT_THROW(key_places(shapes, KeyLayout::line), InputError);
}

TEST(KeyPlaces, WeightsThatAreNoPlaceAreRefused) {
  const KeyPlaces places = key_places(untimed(3), KeyLayout::simplex);
  EXPECT_NO_THROW(places.require_weights(Eigen::Vector3d(0.2, 0.3, 0.5)));
  EXPECT_THROW(places.require_weights(Eigen::Vector3d(0.2, 0.3, 0.6)), InputError);
  EXPECT_THROW(places.require_weights(Eigen::Vector3d(-0.2, 0.6, 0.6)), InputError);
  EXPECT_THROW(places.require_weights(Eigen::Vector2d(0.5, 0.5)), InputError);
}

TEST(WeightsAlongPath, AreEvenlySpacedRoundItsCorners) {
  const std::vector<Eigen::VectorXd> corners = {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1),
                                                Eigen::Vector3d(0, 1, 0)};
  const auto path = weights_along_path(corners, 5);
  ASSERT_EQ(path.size(), 5u);
  EXPECT_TRUE(path[1].isApprox(Eigen::Vector3d(0.5, 0, 0.5)));
  EXPECT_TRUE(path[2].isApprox(corners[1]));
  EXPECT_TRUE(path[3].isApprox(Eigen::Vector3d(0, 0.5, 0.5)));
  EXPECT_TRUE(path[4].isApprox(corners[2]));
  EXPECT_THROW(weights_along_path({corners[0], corners[0]}, 5), InputError);
  EXPECT_THROW(weights_along_path(corners, 1), InputError);
}

}  // namespace
}  // namespace isostack
