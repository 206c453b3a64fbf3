#include "io/dicom/dicom_seg.h"

#include <cstdlib>
#include <numeric>

#include "io/dicom/write_dicom.h"
#include "tests/io/label_support.h"
#include "tests/io/seg_support.h"

namespace isostack::testing {
namespace {

constexpr double tolerance_mm = 1e-6;  // positions have 16 characters, directions 10 decimals over a few pixels

TEST(DicomSeg, FramesInAnyOrderAndOnlyWhereTheSegmentIs) {
  const TemporaryFolder folder;
  // Plane 2 has no frame at all; frames begin within bytes.
  write_bytes(folder / "a", segmentation({{2, 112, other}, {1, 104, dot}, {1, 100, other}, {2, 100, dot}}).file());
  const LabelMap map = read_labels(folder / "a");
  ASSERT_EQ(map.layers.size(), 1u);
  const LabelVolume& labels = map.layers.front();
  EXPECT_EQ(labels.grid.size, Eigen::Vector3i(5, 3, 4));
  EXPECT_LT((labels.grid.index_to_world * Eigen::Vector3d(1, 1, 3) - Eigen::Vector3d(-8, -17, 112)).norm(), 1e-9);
  EXPECT_EQ(labels.at(1, 1, 0), 2);
  EXPECT_EQ(labels.at(4, 2, 0), 1);
  EXPECT_EQ(labels.at(1, 1, 1), 1);
  EXPECT_EQ(labels.at(4, 2, 3), 2);
  EXPECT_EQ(std::accumulate(labels.voxels.begin(), labels.voxels.end(), 0), 2 + 1 + 1 + 2);
  EXPECT_EQ(map.segments[0].name, "one");
  EXPECT_EQ(map.segments[1].value, 2);
}

TEST(DicomSeg, EncodingsGiveTheSameLabels) {
  const TemporaryFolder folder;
  DicomBytes data = segmentation({{1, 100, dot}, {2, 104, other}, {2, 108, dot}});
  write_bytes(folder / "a", data.file());
  const LabelMap expected = read_labels(folder / "a");
  write_bytes(folder / "implicit", data.file({.explicit_vr = false, .big_endian = false}));
  expect_same_map(read_labels(folder / "implicit"), expected, tolerance_mm);
  write_bytes(folder / "big", data.file({.explicit_vr = true, .big_endian = true}));
  expect_same_map(read_labels(folder / "big"), expected, tolerance_mm);
}

TEST(DicomSeg, FractionsCountFromHalfOfTheirMaximum) {
  const TemporaryFolder folder;
  const std::vector<TestFrame> frames = {{1, 100, "0123456789....."}};
  DicomBytes data = with_bytes(segmentation(frames), frames,
                               [](char pixel) { return static_cast<char>(pixel == '.' ? 0 : pixel - '0'); });
  data.text(0x00620001, "CS", "FRACTIONAL").text(0x00620010, "CS", "OCCUPANCY").us(0x0062000e, 9);
  write_bytes(folder / "a", data.file());
  const LabelMap map = read_labels(folder / "a");
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(map.layers.front().voxels[i], i >= 5 ? 1 : 0) << i << " of 9";
}

TEST(DicomSeg, LabelMapsHoldSegmentNumbers) {
  const TemporaryFolder folder;
  const std::vector<TestFrame> frames = {{
                                             0,
                                             104,
                                             "...............",
                                         },
                                         {0, 100, "12............."}};
  DicomBytes data = with_bytes(segmentation(frames), frames,
                               [](char pixel) { return static_cast<char>(pixel == '.' ? 0 : pixel - '0'); });
  data.text(0x00620001, "CS", "LABELMAP").text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.7");
  data.sequence(0x00620002, {segment_item(0, "Background"), segment_item(1, "one"), segment_item(2, "two")});
  write_bytes(folder / "a", data.file());
  const LabelMap map = read_labels(folder / "a");
  ASSERT_EQ(map.segments.size(), 2u);
  EXPECT_EQ(map.layers.front().at(0, 0, 0), 1);
  EXPECT_EQ(map.layers.front().at(1, 0, 0), 2);
  EXPECT_EQ(map.layers.front().grid.size.z(), 2);
}

TEST(DicomSeg, WhatIsWrittenComesBack) {
  const TemporaryFolder folder;
  write_labels(overlapping_organs(), folder / "a.dcm");
  expect_same_map(read_labels(folder / "a.dcm"), overlapping_organs(), tolerance_mm);
  expect_same_grid(read_grid(folder / "a.dcm"), oblique_grid(), tolerance_mm);
}

TEST(DicomSeg, ShearedAndLeftHandedGridsKeepTheirPlaces) {
  Grid sheared = oblique_grid();
  sheared.index_to_world.linear().col(2) += 0.5 * oblique_pose().y_axis;
  const TemporaryFolder folder;
  write_labels(overlapping_organs(sheared), folder / "a.dcm");
  expect_same_map(read_labels(folder / "a.dcm"), overlapping_organs(sheared), tolerance_mm);
  // Planes come back along their normal: against k in a left-handed grid.
  const Grid left = oblique_grid(true);
  write_labels(overlapping_organs(left), folder / "b.dcm");
  const LabelMap map = read_labels(folder / "b.dcm"), expected = overlapping_organs(left);
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(map.layers[0].at(1, 1, k), expected.layers[0].at(1, 1, 4 - k));
    const Eigen::Vector3d place = map.layers[0].grid.index_to_world * Eigen::Vector3d(1, 1, k);
    EXPECT_LT((place - left.index_to_world * Eigen::Vector3d(1, 1, 4 - k)).norm(), tolerance_mm);
  }
}

/// A series whose slices are the planes of oblique_grid().
void write_series_of_grid(const std::filesystem::path& path) {
  SliceStack stack;
  for (int k = 0; k < 5; ++k)
    stack.slices.push_back(
        {"slice " + std::to_string(k), pose_of_plane(oblique_grid(), k, "grid"), Image<float>::Zero(3, 4)});
  write_dicom_series(stack, path);
}

TEST(DicomSeg, RefersToTheSeriesItWasDrawnOn) {
  const TemporaryFolder folder;
  write_series_of_grid(folder / "ct");
  write_labels(overlapping_organs(), folder / "a.dcm", {.like = folder / "ct"});
  const std::string series = bytes_of(folder / "ct" / "slice_0002.dcm"), written = bytes_of(folder / "a.dcm");
  const auto uid_of = [&](const std::string& tag) {  // explicit VR: tag, "UI", length, value
    const std::size_t at = series.find(tag + "UI") + 8;
    return series.substr(at, series.find_first_of(std::string("\0\x08\x20\x28", 4), at) - at);
  };
  const std::string instance = uid_of(std::string("\x08\x00\x18\x00", 4)),
                    study = uid_of(std::string("\x20\x00\x0d\x00", 4));
  ASSERT_EQ(instance.substr(0, 5), "2.25.");
  EXPECT_NE(written.find(instance), std::string::npos);
  EXPECT_NE(written.find(study), std::string::npos);
  EXPECT_EQ(written.find("PHANTOM"), std::string::npos);  // the patient's name
  write_labels(overlapping_organs(), folder / "b.dcm", {.like = folder / "ct", .identify = true});
  EXPECT_NE(bytes_of(folder / "b.dcm").find("PHANTOM"), std::string::npos);
}

TEST(DicomSeg, IsValidDicom) {
  if (std::system("command -v dciodvfy > /dev/null") != 0) GTEST_SKIP() << "dciodvfy (dicom3tools) is not installed";
  const TemporaryFolder folder;
  write_series_of_grid(folder / "ct");
  write_labels(overlapping_organs(), folder / "a.dcm", {.like = folder / "ct"});
  write_labels(overlapping_organs(), folder / "b.dcm");
  for (const char* name : {"a.dcm", "b.dcm"}) {
    const std::string out = (folder / "out").string();
    std::system(("dciodvfy " + (folder / name).string() + " > " + out + " 2>&1").c_str());
    const std::string report = bytes_of(out);
    EXPECT_NE(report.find("Segmentation"), std::string::npos) << report;
    EXPECT_EQ(report.find("Error"), std::string::npos) << report;
  }
}

TEST(DicomSegErrors, DamageIsSurvived) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.dcm", segmentation({{1, 100, dot}, {2, 104, other}, {1, 104, dot}}).file());
  expect_labels_survive_damage(folder / "a.dcm");
}

TEST(DicomSegErrors, ImpossibleFilesAreRefused) {
  const TemporaryFolder folder;
  const auto message_for = [&](const DicomBytes& data) {
    write_bytes(folder / "a.dcm", data.file());
    return message_of([&] { read_labels(folder / "a.dcm"); });
  };
  const auto mentions = [](const std::string& text, const std::string& part) {
    return text.find("a.dcm") != std::string::npos && text.find(part) != std::string::npos;
  };
  const DicomBytes good = segmentation({{1, 100, dot}, {1, 104, dot}, {1, 108, dot}});
  EXPECT_TRUE(mentions(message_for(DicomBytes(good).text(0x00280008, "IS", "1000000000")), "1000000000 frames"));
  EXPECT_TRUE(mentions(message_for(DicomBytes(good).us(0x00280010, 65535).us(0x00280011, 65535)), "65535"));
  EXPECT_TRUE(mentions(message_for(DicomBytes(good).text(0x00280008, "IS", "4")), "4 frames"));
  EXPECT_TRUE(mentions(message_for(DicomBytes(good).text(0x00620001, "CS", "PICTURE")), "PICTURE"));
  EXPECT_TRUE(mentions(message_for(DicomBytes(good).us(0x00280100, 32)), "32 bits"));
  EXPECT_TRUE(mentions(message_for(DicomBytes(good).without(0x52009230)), "frames"));
  EXPECT_TRUE(mentions(message_for(segmentation({{0, 100, dot}})), "which segment"));
  EXPECT_TRUE(mentions(message_for(segmentation({{1, 100, dot}, {1, 101, dot}, {1, 107.43, dot}})), "evenly spaced"));
  EXPECT_TRUE(mentions(message_for(segmentation({{1, 0, dot}, {1, 4000, dot}}, 1)), "planes"));
}

TEST(DicomSegErrors, ASegmentThatNoOneDescribesIsTold) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.dcm", segmentation({{7, 100, dot}}).file());
  const LabelMap map = read_labels(folder / "a.dcm");
  EXPECT_TRUE(has_warning(map.warnings, "undescribed segment: "));
  EXPECT_EQ(map.layers.front().at(1, 1, 0), 7);
}

TEST(DicomSegRealData, LiverAndOverlappingSegmentsEqualTheirNrrds) {
  const auto path = shared_data() / "dicom_seg";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data";
  const LabelMap liver = read_labels(path / "liver.dcm"), liver_nrrd = read_labels(path / "liver_seg.nrrd");
  ASSERT_EQ(liver.layers.size(), 1u);
  EXPECT_EQ(liver.layers.front().voxels, liver_nrrd.layers.front().voxels);
  expect_same_grid(liver.layers.front().grid, liver_nrrd.layers.front().grid, 1e-4);
  EXPECT_EQ(liver.segments.front().name, "Liver");
  EXPECT_EQ(liver.segments.front().color, (Color{221, 130, 101}));  // of the liver in 3D Slicer, which made it
  const LabelMap overlapping = read_labels(path / "partial_overlaps.dcm");
  const std::pair<const char*, std::vector<std::uint16_t>> files[] = {
      {"partial_overlaps-1.nrrd", {1, 4, 5}}, {"partial_overlaps-2.nrrd", {2}}, {"partial_overlaps-3.nrrd", {3}}};
  ASSERT_EQ(overlapping.segments.size(), 5u);
  for (const auto& [name, values] : files) {
    const LabelMap nrrd = read_labels(path / name);
    for (const std::uint16_t value : values) {
      const std::vector<std::uint16_t>& ours = overlapping.layers[overlapping.segments[value - 1u].layer].voxels;
      const std::vector<std::uint16_t>& theirs = nrrd.layers.front().voxels;
      std::size_t differing = 0;
      for (std::size_t i = 0; i < ours.size(); ++i) differing += (ours[i] == value) != (theirs[i] == value);
      EXPECT_EQ(differing, 0u) << name << " value " << value;
    }
  }
}

}  // namespace
}  // namespace isostack::testing
