#include "io/dicom_pixels.h"

#include "io/read_slices.h"
#include "io/write_dicom.h"
#include "io_support.h"

namespace isostack::testing {
namespace {

/// pydicom's test files hold one MR image in many transfer syntaxes.
TEST(DicomPixels, EveryTransferSyntaxGivesTheSameImage) {
  const std::filesystem::path folder = "/usr/lib/python3/dist-packages/pydicom/data/test_files";
  if (!std::filesystem::exists(folder / "MR_small.dcm")) GTEST_SKIP() << "python3-pydicom is not installed";
  const Image<float> expected = read_slices(folder / "MR_small.dcm").slices.front().pixels;
  EXPECT_EQ(expected.maxCoeff(), 2145);  // as pydicom decodes it
  for (const char* name : {"MR_small_RLE.dcm", "MR_small_bigendian.dcm", "MR_small_implicit.dcm",
                           "MR_small_jp2klossless.dcm", "MR_small_jpeg_ls_lossless.dcm", "MR_small_padded.dcm"})
    EXPECT_TRUE((read_slices(folder / name).slices.front().pixels == expected).all()) << name;
}

TEST(DicomPixels, PixelsThatDoNotFillTheImageAreRefused) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0}), folder.path());
  std::string bytes = bytes_of(folder / "slice_0001.dcm");
  const auto at = bytes.find(std::string("\xe0\x7f\x10\0OW\0\0", 8));
  ASSERT_NE(at, std::string::npos);
  bytes[at + 8] = 20;  // length of the pixel data, of 70 bytes
  write_bytes(folder / "slice_0001.dcm", bytes);
  EXPECT_NE(message_of([&] { read_slices(folder.path()); }).find("slice_0001.dcm: its pixels cannot be decoded"),
            std::string::npos);
}

TEST(DicomPixels, SeveralFramesAreRefused) {
  const std::filesystem::path path = "/usr/lib/python3/dist-packages/pydicom/data/test_files/rtdose.dcm";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "python3-pydicom is not installed";
  EXPECT_NE(message_of([&] { read_slices(path); }).find("rtdose.dcm: the file holds 15 frames"), std::string::npos);
}

}  // namespace
}  // namespace isostack::testing
