#include "io/dicom/dicom_fragments.h"

#include <gtest/gtest.h>

#include <string>

namespace isostack::testing {
namespace {

using Starts = std::vector<std::size_t>;

TEST(DicomFragments, FramesOfOneOrSeveralFragments) {
  EXPECT_EQ(frame_starts({"a", "b", "c"}, 3), (Starts{0, 1, 2, 3}));
  EXPECT_EQ(frame_starts({"a", "b", "c"}, 1), (Starts{0, 3}));
  EXPECT_EQ(frame_starts({"\xff\xd8 1", "rest", "\xff\xd8 2"}, 2), (Starts{0, 2, 3}));
  EXPECT_EQ(frame_starts({"\xff\x4f\xff\x51 1", "rest", "\xff\x4f\xff\x51 2", "rest"}, 2), (Starts{0, 2, 4}));
  EXPECT_TRUE(frame_starts({"rest", "\xff\xd8 1", "\xff\xd8 2"}, 2).empty());
  EXPECT_TRUE(frame_starts({"a", "b", "c"}, 2).empty());
  EXPECT_TRUE(frame_starts({}, 2).empty());
}

TEST(DicomFragments, SizesStandInTheCodestream) {
  using std::string_literals::operator""s;
  const std::string jpeg = "\xff\xd8\xff\xe0\0\4ab\xff\xc3\0\x0b\x10\1\2\3\4\1"s;  // comment, then SOF3: 258 rows
  EXPECT_EQ(codestream_size(jpeg), std::pair(0x304, 0x102));
  const std::string jpeg2000 = "\xff\x4f\xff\x51\0\x29\0\0\0\0\0\x19\0\0\0\x0f\0\0\0\5\0\0\0\3"s;
  EXPECT_EQ(codestream_size(jpeg2000), std::pair(20, 12));
  for (std::size_t length = 0; length < 17; ++length) {
    EXPECT_FALSE(codestream_size(std::string_view(jpeg).substr(0, length)));
    EXPECT_FALSE(codestream_size(std::string_view(jpeg2000).substr(0, length)));
  }
  EXPECT_FALSE(codestream_size("run lengths"));
}

}  // namespace
}  // namespace isostack::testing
