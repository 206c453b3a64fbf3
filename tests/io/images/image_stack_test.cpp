#include "io/images/image_stack.h"

#include <fmt/format.h>

#include "tests/io/io_support.h"

namespace isostack::testing {
namespace {

/// A binary BMP of 24 bits whose three channels are equal would be coloured; 8 bits with a grey palette is not
/// written here: an uncompressed greyscale TIFF is the simplest file to make by hand.
std::string tiff(int columns, int rows, int bits, int samples, const std::string& pixels) {
  std::string bytes = "II*";
  bytes += std::string("\0\x08\0\0\0", 5);
  const auto put = [&](std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
  };
  const std::uint32_t pixels_at = 8 + 2 + 9 * 12 + 4;
  const auto entry = [&](std::uint32_t tag, std::uint32_t value) { put(tag, 2), put(4, 2), put(1, 4), put(value, 4); };
  put(9, 2);
  entry(256, static_cast<std::uint32_t>(columns));
  entry(257, static_cast<std::uint32_t>(rows));
  entry(258, static_cast<std::uint32_t>(bits));
  entry(259, 1);                     // uncompressed
  entry(262, samples == 3 ? 2 : 1);  // RGB or black is zero
  entry(273, pixels_at);
  entry(277, static_cast<std::uint32_t>(samples));
  entry(278, static_cast<std::uint32_t>(rows));
  entry(279, static_cast<std::uint32_t>(pixels.size()));
  put(0, 4);
  return bytes + pixels;
}

const ReadOptions spaced = {.spacing_mm = Eigen::Vector3d(0.5, 0.75, 2)};

TEST(ImageStack, NamesOrderNaturallyAndSpacingIsApplied) {
  const TemporaryFolder folder;
  for (const int k : {1, 2, 10})
    write_bytes(folder / fmt::format("slice{}.tif", k), tiff(3, 2, 8, 1, std::string(6, static_cast<char>(k))));
  const SliceStack stack = read_slices(folder.path(), spaced);
  ASSERT_EQ(stack.slices.size(), 3u);
  EXPECT_EQ(stack.slices[2].name, "slice10.tif");
  EXPECT_EQ(stack.slices[2].pose.pixel_to_world({2, 1}), Eigen::Vector3d(1, 0.75, 4));
  EXPECT_TRUE((stack.slices[2].pixels == 10).all());
}

TEST(ImageStack, SixteenBitsKeepTheirValues) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.tif", tiff(2, 2, 16, 1, std::string("\x01\x00\xff\xff\x34\x12\x00\x80", 8)));
  const SliceStack stack = read_slices(folder / "a.tif", spaced);
  ASSERT_EQ(stack.slices.size(), 1u);
  const Image<float>& pixels = stack.slices[0].pixels;
  EXPECT_EQ(pixels(0, 0), 1);
  EXPECT_EQ(pixels(0, 1), 65535);
  EXPECT_EQ(pixels(1, 0), 0x1234);
  EXPECT_EQ(pixels(1, 1), 32768);
}

TEST(ImageStackErrors, SpacingIsRequired) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.tif", tiff(1, 1, 8, 1, "x"));
  EXPECT_NE(message_of([&] { read_slices(folder.path()); }).find("--spacing"), std::string::npos);
  EXPECT_NE(message_of([&] { read_slices(folder.path(), {.spacing_mm = Eigen::Vector3d(1, 0, 1)}); }).find("--spacing"),
            std::string::npos);
}

TEST(ImageStackErrors, ColourDamageAndOtherSizesAreNamed) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.tif", tiff(2, 1, 8, 1, "xy"));
  write_bytes(folder / "b.tif", tiff(1, 1, 8, 1, "x"));
  EXPECT_NE(message_of([&] { read_slices(folder.path(), spaced); }).find("b.tif: the image has 1 x 1 pixels"),
            std::string::npos);
  write_bytes(folder / "b.tif", "II*");
  EXPECT_NE(message_of([&] { read_slices(folder.path(), spaced); }).find("b.tif: the image cannot be decoded"),
            std::string::npos);
  write_bytes(folder / "b.png", tiff(1, 1, 8, 3, "xyz"));
  EXPECT_THROW(read_slices(folder / "b.png", spaced), InputError);
}

}  // namespace
}  // namespace isostack::testing
