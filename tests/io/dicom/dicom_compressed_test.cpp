// Multi-frame images and segmentations in compressed transfer syntaxes.
#include "io/dicom/dicom_seg.h"
#include "io/inspect.h"
#include "io/read_slices.h"
#include "tests/io/compressed_files.h"
#include "tests/io/label_support.h"
#include "tests/io/seg_support.h"

namespace isostack::testing {
namespace {

constexpr int columns = 40, rows = 32, frame_count = 3;  // codecs make little of smaller pictures

/// An enhanced MR image of three frames that are 5 mm apart, of 12 bits, smooth but for an edge.
std::string enhanced_image() {
  DicomBytes data = picture_at(0, "1.2.3").text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.4.1");
  data.text(0x00280008, "IS", std::to_string(frame_count)).us(0x00280010, rows).us(0x00280011, columns);
  data.us(0x00280101, 12).us(0x00280102, 11);
  std::vector<DicomBytes> items(frame_count);
  std::string pixels;
  for (int f = 0; f < frame_count; ++f) {
    items[static_cast<std::size_t>(f)].sequence(0x00209113,
                                                {DicomBytes().text(0x00200032, "DS", decimals({0, 0, 5.0 * f}))});
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        pixels += little(static_cast<std::uint64_t>(1000 * f + 7 * row + column + (column > 20 ? 900 : 0)), 2);
  }
  return data.sequence(0x52009230, items).set(0x7fe00010, "OW", pixels, 2).file();
}

TEST(DicomCompressed, MultiFrameImagesInEverySyntax) {
  if (!can_compress_dicom()) GTEST_SKIP() << "gdcmconv (libgdcm-tools) is not installed";
  const TemporaryFolder folder;
  write_bytes(folder / "plain", enhanced_image());
  const SliceStack plain = read_slices(folder / "plain");
  ASSERT_EQ(plain.slices.size(), 3u);
  EXPECT_EQ(plain.slices[2].pixels(4, 30), 2000 + 28 + 930);
  for (const char* how : {"rle", "jpeg", "jpegls", "j2k", "deflated"}) {
    SCOPED_TRACE(how);
    ASSERT_TRUE(compress_dicom(folder / "plain", folder / how, how));
    EXPECT_NE(inspect(folder / how).front().encoding, inspect(folder / "plain").front().encoding);
    const SliceStack stack = read_slices(folder / how);
    ASSERT_EQ(stack.slices.size(), plain.slices.size());
    for (std::size_t i = 0; i < stack.slices.size(); ++i) {
      EXPECT_TRUE((stack.slices[i].pixels == plain.slices[i].pixels).all()) << "frame " << i;
      EXPECT_EQ(stack.slices[i].pose.origin_mm, plain.slices[i].pose.origin_mm);
    }
  }
}

/// Frames of 40 x 32 pixels with a disc of segment 1, 2, 1 at 100, 104, 108 mm.
DicomBytes large_segmentation(int inside, bool is_label_map) {
  DicomBytes data =
      segmentation({{is_label_map ? 0 : 1, 100, ""}, {is_label_map ? 0 : 2, 104, ""}, {is_label_map ? 0 : 1, 108, ""}});
  std::string pixels;
  for (int f = 0; f < frame_count; ++f)
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const bool is_inside = std::hypot(row - 15, column - 18 - f) < 9;
        pixels += static_cast<char>(!is_inside ? 0 : is_label_map ? 1 + f % 2 : inside);
      }
  data.us(0x00280010, rows).us(0x00280011, columns);
  return data.us(0x00280100, 8).us(0x00280101, 8).us(0x00280102, 7).set(0x7fe00010, "OB", pixels, 1);
}

TEST(DicomCompressed, SegmentationsInEverySyntax) {
  if (!can_compress_dicom()) GTEST_SKIP() << "gdcmconv (libgdcm-tools) is not installed";
  const TemporaryFolder folder;
  DicomBytes fractional = large_segmentation(200, false), label_map = large_segmentation(0, true);
  fractional.text(0x00620001, "CS", "FRACTIONAL").text(0x00620010, "CS", "OCCUPANCY").us(0x0062000e, 255);
  label_map.text(0x00620001, "CS", "LABELMAP");  // the tool does not know the storage class of label maps
  for (const DicomBytes& data : {fractional, label_map}) {
    write_bytes(folder / "plain", data.file());
    const LabelMap plain = read_labels(folder / "plain");
    ASSERT_EQ(plain.layers.front().grid.size, Eigen::Vector3i(columns, rows, frame_count));
    EXPECT_EQ(plain.layers.front().at(19, 15, 1), 2);
    EXPECT_EQ(plain.layers.front().at(19, 15, 2), 1);
    for (const char* how : {"rle", "jpeg", "jpegls", "j2k", "deflated"}) {
      SCOPED_TRACE(how);
      ASSERT_TRUE(compress_dicom(folder / "plain", folder / how, how));
      expect_same_map(read_labels(folder / how), plain, 1e-9);
    }
  }
}

TEST(DicomCompressed, DeflatedSingleBits) {
  if (!can_compress_dicom()) GTEST_SKIP() << "gdcmconv (libgdcm-tools) is not installed";
  const TemporaryFolder folder;
  write_bytes(folder / "plain", segmentation({{1, 100, dot}, {2, 104, other}, {2, 108, dot}}).file());
  ASSERT_TRUE(compress_dicom(folder / "plain", folder / "deflated", "deflated"));
  expect_same_map(read_labels(folder / "deflated"), read_labels(folder / "plain"), 1e-9);
}

TEST(DicomCompressed, RescaleAndSignOfASegmentationMeanNothing) {
  if (!can_compress_dicom()) GTEST_SKIP() << "gdcmconv (libgdcm-tools) is not installed";
  const TemporaryFolder folder;
  DicomBytes data = large_segmentation(200, false);
  data.text(0x00620001, "CS", "FRACTIONAL").us(0x0062000e, 255);
  write_bytes(folder / "plain", data.file());
  const LabelMap plain = read_labels(folder / "plain");
  data.text(0x00281052, "DS", "-1e30").text(0x00281053, "DS", "1e30");
  write_bytes(folder / "scaled", data.file());
  ASSERT_TRUE(compress_dicom(folder / "scaled", folder / "rle", "rle"));
  expect_same_map(read_labels(folder / "rle"), plain, 1e-9);
}

TEST(DicomCompressed, DamageIsSurvived) {
  if (!can_compress_dicom()) GTEST_SKIP() << "gdcmconv (libgdcm-tools) is not installed";
  const TemporaryFolder folder;
  DicomBytes data = large_segmentation(0, true);
  data.text(0x00620001, "CS", "LABELMAP");
  write_bytes(folder / "plain", data.file());
  for (const char* how : {"rle", "jpegls"}) {
    ASSERT_TRUE(compress_dicom(folder / "plain", folder / how, how));
    expect_labels_survive_damage(folder / how);
  }
}

}  // namespace
}  // namespace isostack::testing
