#include "io/file_listing.h"

#include "tests/io/io_support.h"

namespace isostack::testing {
namespace {

TEST(FileListing, NumbersOrderByValue) {
  EXPECT_TRUE(natural_less("slice2.png", "slice10.png"));
  EXPECT_FALSE(natural_less("slice10.png", "slice2.png"));
  EXPECT_TRUE(natural_less("a007b2", "a7b10"));
  EXPECT_TRUE(natural_less("a", "a1"));
  EXPECT_FALSE(natural_less("a1", "a1"));
  EXPECT_TRUE(natural_less("99999999999999999998", "99999999999999999999"));  // beyond 64 bits
}

TEST(FileListing, EqualNumbersOfOtherLengthHaveOneOrder) {
  EXPECT_NE(natural_less("a01", "a1"), natural_less("a1", "a01"));
}

TEST(FileListing, FollowsLinksToFilesNotToFoldersAndGoesDownOnlyWhenAsked) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "below");
  write_bytes(folder / "2.txt", "");
  write_bytes(folder / "10.txt", "");
  write_bytes(folder / "below/1.txt", "");
  std::filesystem::create_symlink(folder.path(), folder / "loop");
  std::filesystem::create_symlink(folder / "2.txt", folder / "3.txt");
  std::filesystem::create_symlink(folder / "nowhere.txt", folder / "4.txt");
  const auto here = files_in(folder.path(), Depth::kThisFolder);
  ASSERT_EQ(here.size(), 3u);
  EXPECT_EQ(here[0].filename(), "2.txt");
  EXPECT_EQ(here[1].filename(), "3.txt");
  EXPECT_EQ(here[2].filename(), "10.txt");
  EXPECT_EQ(files_in(folder.path(), Depth::kAllBelow).size(), 4u);
}

}  // namespace
}  // namespace isostack::testing
