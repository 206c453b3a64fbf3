#include "io/dicom/stored_pixels.h"

#include "io/read_slices.h"
#include "tests/io/dicom_bytes.h"

namespace isostack::testing {
namespace {

struct Kind {
  int bits_allocated, bits_stored, high_bit;
  bool is_signed;
  std::uint64_t stored;  ///< the word in the file
  double value;          ///< what it means
};

TEST(StoredPixels, BitsSignsAndByteOrders) {
  const Kind kinds[] = {
      {8, 8, 7, false, 0xfe, 254},
      {8, 8, 7, true, 0xfe, -2},
      {16, 16, 15, false, 0xfffe, 65534},
      {16, 16, 15, true, 0xfffe, -2},
      {16, 12, 11, false, 0xfffe, 4094},  // overlays in the upper bits
      {16, 12, 11, true, 0x0ffe, -2},     // sign not extended
      {16, 12, 11, true, 0xfffe, -2},     // and extended
      {16, 12, 15, false, 0xffef, 4094},  // pixels in the upper bits
      {32, 32, 31, false, 0xfffffffe, 4294967294.0},
      {32, 32, 31, true, 0xfffffffe, -2},
  };
  const TemporaryFolder folder;
  for (const Kind& kind : kinds)
    for (const bool big_endian : {false, true}) {
      DicomBytes data = picture_at(0, "1.2.3");
      data.us(0x00280100, kind.bits_allocated).us(0x00280101, kind.bits_stored).us(0x00280102, kind.high_bit);
      data.us(0x00280103, kind.is_signed ? 1 : 0);
      std::string pixels;
      for (int i = 0; i < test_pixels; ++i)
        pixels += little(i == 7 ? kind.stored : static_cast<std::uint64_t>(i) << (kind.high_bit + 1 - kind.bits_stored),
                         kind.bits_allocated / 8);
      data.set(0x7fe00010, "OW", pixels, std::max(2, kind.bits_allocated / 8));
      write_bytes(folder / "x.dcm", data.file({true, big_endian}));
      const Image<float> read = read_slices(folder / "x.dcm").slices.front().pixels;
      EXPECT_EQ(read.data()[7], static_cast<float>(kind.value)) << kind.bits_stored << " of " << kind.bits_allocated;
      EXPECT_EQ(read.data()[6], 6);
      EXPECT_EQ(read.data()[9], 9);
    }
}

TEST(StoredPixels, PicturesThatAreReadPieceByPiece) {
  const int columns = 331, rows = 257;  // 170 kB, no multiple of any buffer
  const TemporaryFolder folder;
  for (const bool big_endian : {false, true}) {
    DicomBytes data = picture_at(0, "1.2.3").us(0x00280010, rows).us(0x00280011, columns);
    std::string pixels;
    for (int i = 0; i < rows * columns; ++i) pixels += little(static_cast<std::uint64_t>(i % 65521), 2);
    write_bytes(folder / "x.dcm", data.set(0x7fe00010, "OW", pixels, 2).file({true, big_endian}));
    const Image<float> read = read_slices(folder / "x.dcm").slices.front().pixels;
    int differing = 0;
    for (int i = 0; i < rows * columns; ++i) differing += read.data()[i] != static_cast<float>(i % 65521);
    EXPECT_EQ(differing, 0);
  }
}

}  // namespace
}  // namespace isostack::testing
