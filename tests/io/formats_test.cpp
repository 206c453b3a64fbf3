#include "io/formats.h"

#include "io/meshes/read_mesh.h"
#include "io/meshes/write_mesh.h"
#include "io/volumes/volume_files.h"
#include "tests/io/io_support.h"

namespace isostack::testing {
namespace {

TEST(Formats, ExtensionsAreFoundInAnyCase) {
  EXPECT_EQ(find_format("A.NII.GZ", &Format::read_volume)->name, "NIfTI");
  EXPECT_EQ(find_format("a.Stl", &Format::write_mesh)->name, "STL");
  EXPECT_EQ(find_format("a.gz", &Format::read_volume), nullptr);
}

TEST(Formats, AbilityDecidesAmongFormats) {
  EXPECT_NE(find_format("a.vtp", &Format::write_mesh), nullptr);
  EXPECT_NE(find_format("a.vtp", &Format::write_contours), nullptr);
  EXPECT_EQ(find_format("a.gltf", &Format::read_mesh), nullptr);
}

TEST(Formats, UnknownExtensionListsWhatWouldDo) {
  const std::string message = message_of([] { write_mesh({}, "liver.xyz"); });
  EXPECT_NE(message.find("liver.xyz: unknown extension .xyz for a mesh; use .stl, .ply, .obj, .vtp, .gltf, .glb."),
            std::string::npos)
      << message;
  EXPECT_NE(message_of([] { write_labels({}, "liver"); }).find(".nii.gz, .nii"), std::string::npos);
}

TEST(Formats, NoExtensionIsRegisteredTwiceForOneAbility) {
  std::vector<std::string_view> meshes = extensions_with(&Format::read_mesh);
  std::sort(meshes.begin(), meshes.end());
  EXPECT_EQ(std::adjacent_find(meshes.begin(), meshes.end()), meshes.end());
}

}  // namespace
}  // namespace isostack::testing
