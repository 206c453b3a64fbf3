#include "io/dicom/dicom_pixels.h"

#include "io/dicom/write_dicom.h"
#include "io/read_slices.h"
#include "tests/io/io_support.h"

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

TEST(DicomPixels, DeflatedPixelsAreInflatedAndDamageIsNoticed) {
  const std::filesystem::path path = "/usr/lib/python3/dist-packages/pydicom/data/test_files/image_dfl.dcm";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "python3-pydicom is not installed";
  const Image<float> pixels = read_dicom_pixels({read_dicom_header(path)}).front();
  EXPECT_EQ(pixels.rows(), 512);
  EXPECT_GT(pixels.maxCoeff(), pixels.minCoeff());
  const TemporaryFolder folder;
  std::string bytes = bytes_of(path);
  for (std::size_t i = 1000; i < bytes.size(); i += 97) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    write_bytes(folder / "x.dcm", damaged);
    try {  // either way, but never GDCM's assertion
      read_dicom_header(folder / "x.dcm");
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("x.dcm: "), std::string::npos);
    }
    write_bytes(folder / "x.dcm", bytes.substr(0, i));
    EXPECT_THROW(read_dicom_header(folder / "x.dcm"), Error);
  }
}

TEST(DicomPixels, PixelsThatDoNotFillTheImageAreRefused) {
  const TemporaryFolder folder;
  write_dicom_series(oblique_stack({0}), folder.path());
  std::string bytes = bytes_of(folder / "slice_0001.dcm");
  const auto at = bytes.find(std::string("\xe0\x7f\x10\0OW\0\0", 8));
  ASSERT_NE(at, std::string::npos);
  bytes[at + 8] = 20;  // length of the pixel data, of 70 bytes
  write_bytes(folder / "slice_0001.dcm", bytes);
  EXPECT_NE(
      message_of([&] { read_slices(folder.path()); }).find("slice_0001.dcm: it claims 1 frame(s) of 7 x 5 pixels"),
      std::string::npos);
}

}  // namespace
}  // namespace isostack::testing
