#include "io/images/write_pictures.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/images/image_stack.h"
#include "recon/geometry/errors.h"
#include "tests/support/gif_blocks.h"

namespace isostack {
namespace {

class WritePictures : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::path(testing::TempDir()) / ("isostack_pictures_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::filesystem::path folder;
};

Picture one_colour(int width, int height, std::uint8_t value) {
  Picture picture{.width_pixels = width, .height_pixels = height, .rgb = {}};
  picture.rgb.assign(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value);
  return picture;
}

TEST_F(WritePictures, GreyPngComesBackAsItWas) {
  Image<std::uint8_t> pixels(3, 5);
  for (int i = 0; i < pixels.size(); ++i) pixels.data()[i] = static_cast<std::uint8_t>(17 * i);
  write_png(pixels, folder / "grey.png");
  const SliceStack stack = read_image_stack(folder / "grey.png", {.spacing_mm = Eigen::Vector3d::Ones()}, Progress{});
  ASSERT_EQ(stack.slices.size(), 1u);
  EXPECT_TRUE((stack.slices[0].pixels == pixels.cast<float>()).all());
}

TEST_F(WritePictures, ColourPngHasItsSize) {
  write_png(one_colour(7, 4, 90), folder / "colour.png");
  const ImageInfo info = image_info(folder / "colour.png");
  EXPECT_EQ(info.columns, 7);
  EXPECT_EQ(info.rows, 4);
  EXPECT_EQ(info.format, "png");
}

TEST_F(WritePictures, GifHasAllPicturesTheirTimeAndNoEnd) {
  write_gif({one_colour(8, 6, 0), one_colour(8, 6, 128), one_colour(8, 6, 128), one_colour(8, 6, 255)},
            folder / "a.gif", {.frames_per_second = 25});
  const testing_support::GifBlocks gif = testing_support::gif_blocks(folder / "a.gif");
  EXPECT_EQ(gif.width, 8);
  EXPECT_EQ(gif.height, 6);
  EXPECT_EQ(gif.delays_hundredths, std::vector<int>(4, 4));  // also of the picture that is like the one before
  EXPECT_EQ(gif.pictures, 4);
  EXPECT_EQ(gif.loops, 0);
}

TEST_F(WritePictures, RefusalsLeaveNothing) {
  EXPECT_THROW(write_gif({}, folder / "a.gif"), InputError);
  EXPECT_THROW(write_gif({one_colour(8, 6, 0), one_colour(6, 8, 0)}, folder / "a.gif"), InputError);
  EXPECT_THROW(write_png(Picture{}, folder / "a.png"), InputError);
  EXPECT_THROW(write_png(one_colour(2, 2, 0), folder / "nowhere" / "a.png"), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace isostack
