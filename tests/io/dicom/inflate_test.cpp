#include "io/dicom/inflate.h"

#include <gtest/gtest.h>

namespace isostack::testing {
namespace {

using std::string_literals::operator""s;

TEST(Inflate, StoredBlocks) {
  const std::string deflated =
      "\1\3\0\xfc\xff"
      "abc"s;  // one block of 3 bytes as they are, the last
  EXPECT_EQ(inflate_raw(deflated, 3), "abc");
  EXPECT_EQ(inflate_raw(deflated + "behind", 3), "abc");
  EXPECT_FALSE(inflate_raw(deflated, 2));
  for (std::size_t length = 0; length < deflated.size(); ++length)
    EXPECT_FALSE(inflate_raw(std::string_view(deflated).substr(0, length), 3));
  EXPECT_FALSE(inflate_raw("\7", 3));  // no such kind of block
}

}  // namespace
}  // namespace isostack::testing
