#include "recon/geometry/label_map.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

LabelVolume line(const std::vector<std::uint16_t>& voxels) {
  Grid grid;
  grid.size = {static_cast<int>(voxels.size()), 1, 1};
  LabelVolume volume(grid);
  volume.voxels = voxels;
  return volume;
}

TEST(LabelMap, ValuesWithoutASegmentAreOrgansToo) {
  const LabelMap map{.layers = {line({0, 3, 3, 7})}, .segments = {{.name = "liver", .value = 7}}};
  const std::vector<Segment> all = all_segments(map);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "liver");
  EXPECT_EQ(all[1].name, "3");
  EXPECT_EQ(all[1].value, 3);
}

TEST(LabelMap, AChoiceIsANameBeforeItIsANumber) {
  const LabelMap map{.layers = {line({1, 2, 3, 4})},
                     .segments = {{.name = "liver", .value = 1}, {.name = "3", .value = 2}}};
  const auto value_of = [&](const std::string& choice) {
    const std::vector<Segment> chosen = chosen_segments(map, choice, "scan.nrrd");
    return chosen.size() == 1 ? static_cast<int>(chosen.front().value) : -1;
  };
  EXPECT_EQ(value_of("liver"), 1);
  EXPECT_EQ(value_of("1"), 1);
  EXPECT_EQ(value_of("4"), 4);
  const std::vector<Segment> three = chosen_segments(map, "3", "scan.nrrd");
  ASSERT_EQ(three.size(), 2u);  // named 3, and without a name and so called by its number
  EXPECT_EQ(three[0].value, 2);
  EXPECT_EQ(three[1].value, 3);
  EXPECT_EQ(chosen_segments(map, "all", "scan.nrrd").size(), 4u);
}

TEST(LabelMap, AMissingChoiceTellsWhatThereIs) {
  const LabelMap map{.layers = {line({0, 5, 6})}, .segments = {{.name = "liver", .value = 5}}};
  try {
    chosen_segments(map, "spleen", "scan.nrrd");
    FAIL() << "a label that is not there was found";
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "scan.nrrd");
    EXPECT_NE(error.problem().find("spleen"), std::string::npos);
    EXPECT_NE(error.remedy().find("5 (liver), 6"), std::string::npos) << error.remedy();
  }
  EXPECT_THROW(chosen_segments({.layers = {line({0, 0})}, .segments = {}}, "all", "empty.nrrd"), InputError);
}

TEST(LabelMap, OnlyOverlappingOrgansTakeAnotherLayer) {
  LabelMap map{.layers = {line({0, 0, 0, 0})}, .segments = {}};
  add_segment(map, line({1, 1, 0, 0}), {.name = "a", .value = 1});
  add_segment(map, line({0, 1, 1, 0}), {.name = "b", .value = 2});
  add_segment(map, line({0, 0, 0, 1}), {.name = "c", .value = 3});
  ASSERT_EQ(map.layers.size(), 2u);
  EXPECT_EQ(map.layers[0].voxels, (std::vector<std::uint16_t>{1, 1, 0, 3}));
  EXPECT_EQ(map.layers[1].voxels, (std::vector<std::uint16_t>{0, 2, 2, 0}));
  EXPECT_EQ(map.segments[2].layer, 0u);
}

TEST(LabelMap, FlattenedTellsWhatItLost) {
  const LabelMap map{.layers = {line({1, 1, 0, 9}), line({0, 1, 1, 0})},
                     .segments = {{.name = "a", .value = 1, .layer = 0}, {.name = "b", .value = 1, .layer = 1}}};
  std::size_t overlapping = 0;
  const LabelMap flat = flattened(map, &overlapping);
  EXPECT_EQ(overlapping, 1u);
  ASSERT_EQ(flat.layers.size(), 1u);
  ASSERT_EQ(flat.segments.size(), 3u);  // and the one without a name
  const std::uint16_t b = flat.segments[1].value;
  EXPECT_NE(b, flat.segments[0].value);
  EXPECT_EQ(flat.layers[0].voxels, (std::vector<std::uint16_t>{1, b, b, 9}));
}

}  // namespace
}  // namespace isostack
