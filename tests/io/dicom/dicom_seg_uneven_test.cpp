// Segmentations whose frames no even grid holds.
#include "io/dicom/dicom_seg.h"
#include "io/volumes/volume_files.h"
#include "tests/io/label_support.h"
#include "tests/io/seg_support.h"

namespace isostack::testing {
namespace {

/// Number of voxels of a segment on the map's only plane.
int voxels_of(const LabelMap& map, const std::string& name) {
  for (const Segment& segment : map.segments)
    if (segment.name == name)
      return static_cast<int>(std::count(map.layers.at(segment.layer).voxels.begin(),
                                         map.layers.at(segment.layer).voxels.end(), segment.value));
  return -1;
}

TEST(DicomSegUneven, EachPlaneIsReadAtItsOwnPlace) {
  const TemporaryFolder folder;
  // Frames out of order, both segments on one plane, where they overlap.
  write_bytes(
      folder / "a",
      segmentation(
          {{1, 107.43, "###............"}, {1, 100, dot}, {2, 101, "##............."}, {2, 107.43, "..####........."}})
          .file());
  const std::vector<LabelMap> maps = read_label_planes(folder / "a");
  ASSERT_EQ(maps.size(), 3u);
  const double heights_mm[] = {100, 101, 107.43};
  for (std::size_t i = 0; i < 3; ++i) {
    const Grid& grid = maps[i].layers.front().grid;
    EXPECT_EQ(grid.size, Eigen::Vector3i(5, 3, 1));
    EXPECT_LT((grid.index_to_world * Eigen::Vector3d(1, 1, 0) - Eigen::Vector3d(-8, -17, heights_mm[i])).norm(), 1e-9);
  }
  EXPECT_EQ(voxels_of(maps[0], "one"), 1);
  EXPECT_EQ(voxels_of(maps[0], "two"), 0);
  EXPECT_EQ(voxels_of(maps[1], "one"), 0);
  EXPECT_EQ(voxels_of(maps[1], "two"), 2);
  EXPECT_EQ(voxels_of(maps[2], "one"), 3);
  EXPECT_EQ(voxels_of(maps[2], "two"), 4);
  EXPECT_EQ(maps[2].layers.size(), 2u);
  EXPECT_TRUE(has_warning(maps[0].warnings, "uneven frames: its frames are not evenly spaced; each of its 3 planes"));
}

TEST(DicomSegUneven, EvenFramesAreOneMap) {
  const TemporaryFolder folder;
  write_bytes(folder / "a", segmentation({{1, 104, dot}, {1, 100, dot}, {2, 112, dot}}).file());
  const std::vector<LabelMap> maps = read_label_planes(folder / "a");
  ASSERT_EQ(maps.size(), 1u);
  expect_same_map(maps.front(), read_labels(folder / "a"), 1e-9);
}

/// A frame with a pose of its own.
DicomBytes frame_with_pose(const std::string& position, const std::string& orientation) {
  DicomBytes place, direction, item = frame_item({1, 0, dot});
  place.text(0x00200032, "DS", position);
  direction.text(0x00200037, "DS", orientation);
  return item.sequence(0x00209113, {place}).sequence(0x00209116, {direction});
}

TEST(DicomSegUneven, OrientationsAndShiftsMayDiffer) {
  const TemporaryFolder folder;
  DicomBytes data = segmentation({{1, 100, dot}, {1, 104, dot}, {1, 108, dot}});
  data.sequence(0x52009230, {frame_with_pose("-10\\-20\\100", "1\\0\\0\\0\\1\\0"),
                             frame_with_pose("-10\\-20\\104", "0\\1\\0\\0\\0\\-1"),
                             frame_with_pose("-10\\-20\\108", "1\\0\\0\\0\\1\\0")});
  write_bytes(folder / "a", data.file());
  std::vector<LabelMap> maps = read_label_planes(folder / "a");
  ASSERT_EQ(maps.size(), 3u);
  // Parallel planes first; one pixel right and one down of the sagittal plane are along y and against z.
  const Eigen::Vector3d place = maps[2].layers.front().grid.index_to_world * Eigen::Vector3d(1, 1, 0);
  EXPECT_LT((place - Eigen::Vector3d(-10, -18, 101)).norm(), 1e-9);
  data.sequence(0x52009230, {frame_with_pose("-10\\-20\\100", "1\\0\\0\\0\\1\\0"),
                             frame_with_pose("-7\\-20\\104", "1\\0\\0\\0\\1\\0"),
                             frame_with_pose("-10\\-20\\108", "1\\0\\0\\0\\1\\0")});
  write_bytes(folder / "a", data.file());
  maps = read_label_planes(folder / "a");
  ASSERT_EQ(maps.size(), 3u);
  EXPECT_LT((maps[1].layers.front().grid.index_to_world.translation() - Eigen::Vector3d(-7, -20, 104)).norm(), 1e-9);
}

TEST(DicomSegUneven, LabelMapsAreSplitByPlane) {
  const TemporaryFolder folder;
  const std::vector<TestFrame> frames = {
      {0, 100, "12............."}, {0, 101, "..1............"}, {0, 109, "222............"}};
  DicomBytes data = with_bytes(segmentation(frames), frames,
                               [](char pixel) { return static_cast<char>(pixel == '.' ? 0 : pixel - '0'); });
  data.text(0x00620001, "CS", "LABELMAP").text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.7");
  data.sequence(0x52009230, {frame_with_pose("-10\\-20\\100", "1\\0\\0\\0\\1\\0"),
                             frame_with_pose("-10\\-20\\101.1", "1\\0\\0\\0\\1\\0"),
                             frame_with_pose("-10\\-20\\109", "1\\0\\0\\0\\1\\0")});
  write_bytes(folder / "a", data.file());
  const std::vector<LabelMap> maps = read_label_planes(folder / "a");
  ASSERT_EQ(maps.size(), 3u);
  EXPECT_EQ(voxels_of(maps[0], "one"), 1);
  EXPECT_EQ(voxels_of(maps[1], "one"), 1);
  EXPECT_EQ(voxels_of(maps[2], "two"), 3);
}

TEST(DicomSegUneven, AsOneGridItIsRefusedWithTheWayOut) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.dcm", segmentation({{1, 100, dot}, {1, 101, dot}, {1, 107.43, dot}}).file());
  const std::string message = message_of([&] { read_labels(folder / "a.dcm"); });
  EXPECT_NE(message.find("a.dcm: its frames are not evenly spaced"), std::string::npos) << message;
  EXPECT_NE(message.find("take contours"), std::string::npos) << message;
}

}  // namespace
}  // namespace isostack::testing
