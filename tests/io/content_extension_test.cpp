#include "io/content_extension.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace isostack {
namespace {

std::string at(std::size_t offset, const std::string& bytes) { return std::string(offset, '\0') + bytes; }

TEST(ContentExtension, FirstBytesTellTheFormat) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {at(128, "DICM"), ".dcm"},
      {at(344, std::string("n+1\0", 4)), ".nii"},
      {"\x1f\x8b\x08", ".nii.gz"},
      {"NRRD0004\n", ".nrrd"},
      {"ObjectType = Image\n", ".mha"},
      {"ply\nformat ascii 1.0\n", ".ply"},
      {"solid organ\nfacet normal 0 0 1\n", ".stl"},
      {"<?xml version=\"1.0\"?>\n<VTKFile", ".vtp"},
      {"\n  {\"format\": 1}", ".json"},
      {"CSLC\n3 2\n", ".csl"},
      {"# made by hand\nv 0 0 0\n", ".obj"},
  };
  for (const auto& [bytes, extension] : cases) EXPECT_EQ(content_extension(bytes, bytes.size()), extension);
}

TEST(ContentExtension, BinaryStlByItsSizeWhateverItsHeaderSays) {
  std::string stl(84 + 50 * 7, '\1');
  std::memcpy(stl.data(), "solid but not text", 18);
  const std::uint32_t triangles = 7;
  std::memcpy(stl.data() + 80, &triangles, sizeof triangles);
  EXPECT_EQ(content_extension(stl.substr(0, 200), stl.size()), ".stl");
  stl[0] = 'x';
  EXPECT_EQ(content_extension(stl, stl.size()), ".stl");
  EXPECT_EQ(content_extension(stl, stl.size() + 1), "");  // one byte too many is another format
}

TEST(ContentExtension, NothingForWhatIsNoKnownFormat) {
  for (const std::string text : {"", "#", "hello", "# only\n# comments", "vector graphics"})
    EXPECT_EQ(content_extension(text, text.size()), "") << text;
}

}  // namespace
}  // namespace isostack
