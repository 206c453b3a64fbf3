#include <gtest/gtest.h>

#include "io/contours/contour_files.h"
#include "io/meshes/read_mesh.h"
#include "io/meshes/write_mesh.h"
#include "io/volumes/volume_files.h"
#include "tests/cli/program.h"
#include "tests/support/convertible.h"

namespace isostack::testing_support {
namespace {

class ConvertTest : public ProgramTest {
 protected:
  /// Each file from the one before, the last like the first; every format once as input and once as output.
  void convert_in_turn(const std::vector<std::string>& names) {
    for (std::size_t i = 1; i < names.size(); ++i) {
      const ProgramRun run = isostack("convert " + path(names[i - 1]) + " -o " + path(names[i]));
      ASSERT_EQ(run.exit_code, 0) << names[i] << ": " << run.err;
    }
  }
};

TEST_F(ConvertTest, MeshesComeBackFromEveryFormat) {
  write_mesh(octahedron(), path("a.ply"));
  convert_in_turn({"a.ply", "b.obj", "c.vtp", "d.ply"});
  EXPECT_EQ(file_text(path("d.ply")), file_text(path("a.ply")));  // whole numbers: nothing is rounded
  convert_in_turn({"a.ply", "e.stl", "f.glb"});
  EXPECT_EQ(read_mesh(path("e.stl")).triangles.size(), 8u);
}

TEST_F(ConvertTest, MeshesAreRemeshedOnTheWay) {
  write_mesh(octahedron(), path("a.ply"));
  ASSERT_EQ(isostack("convert " + path("a.ply") + " --edge-length 5 -o " + path("b.ply")).exit_code, 0);
  EXPECT_GT(read_mesh(path("b.ply")).triangles.size(), 8u);
  ASSERT_EQ(isostack("convert " + path("b.ply") + " --triangles 8 -o " + path("c.ply")).exit_code, 0);
  EXPECT_EQ(read_mesh(path("c.ply")).triangles.size(), 8u);
}

TEST_F(ConvertTest, ContoursComeBackFromEveryFormat) {
  write_contours(two_organs(), path("a.json"));
  convert_in_turn({"a.json", "b.vtp", "c.json"});
  EXPECT_EQ(file_text(path("c.json")), file_text(path("a.json")));
  convert_in_turn({"a.json", "d.csl", "e.contour", "f.dcm"});
  EXPECT_EQ(read_contours(path("f.dcm")).size(), 2u);
  ASSERT_EQ(isostack("convert " + path("a.json") + " --organ tumour -o " + path("g.vtp")).exit_code, 0);
  EXPECT_EQ(read_contours(path("g.vtp")).at(0).name, "tumour");
}

TEST_F(ConvertTest, FormatsThatSpeakOfEveryPlaneAreNoted) {
  std::vector<ContourStack> organs = two_organs();
  organs[1].slices.pop_back();
  write_contours(organs, path("a.json"));
  const ProgramRun run = isostack("convert " + path("a.json") + " -o " + path("b.csl"));
  EXPECT_NE(run.err.find("tumour: 1 of 3 planes say nothing about it"), std::string::npos) << run.err;
}

TEST_F(ConvertTest, OrgansThatAFormatCannotHoldAreNoted) {
  std::vector<ContourStack> organs = two_organs();
  organs.push_back(ContourStack{.name = "spleen", .slices = {}});
  write_contours(organs, path("a.json"));
  const ProgramRun edges = isostack("convert " + path("a.json") + " -o " + path("b.contour"));
  EXPECT_EQ(edges.exit_code, 0);
  EXPECT_NE(edges.err.find("spleen: it has no contours, so b.contour cannot hold it"), std::string::npos) << edges.err;
  const ProgramRun structure_set = isostack("convert " + path("a.json") + " -o " + path("b.dcm"));
  EXPECT_EQ(structure_set.err.find("cannot hold it"), std::string::npos) << structure_set.err;
  EXPECT_EQ(read_contours(path("b.dcm")).at(2).name, "spleen");
}

TEST_F(ConvertTest, VolumesComeBackFromEveryFormat) {
  write_volume(ramp(), path("a.nii"));
  convert_in_turn({"a.nii", "b.nrrd", "c.mha", "d.nii.gz", "e.nii"});
  EXPECT_EQ(read_stored_volume(path("e.nii")).bytes, ramp().bytes);
  EXPECT_EQ(read_stored_volume(path("c.mha")).header.value_type, "int16");
}

TEST_F(ConvertTest, LabelsKeepTheirNames) {
  write_labels(two_labels(), path("a.seg.nrrd"));
  convert_in_turn({"a.seg.nrrd", "b.nii.gz", "c.seg.nrrd"});
  const LabelMap read = read_labels(path("c.seg.nrrd"));
  EXPECT_EQ(read.layers.at(0).voxels, two_labels().layers[0].voxels);
  ASSERT_EQ(read.segments.size(), 2u);
  EXPECT_EQ(read.segments[0].name, "liver");
  EXPECT_EQ(read.segments[0].color, (Color{9, 8, 7}));
}

TEST_F(ConvertTest, AxesAreTurnedOnAsking) {
  write_mesh(octahedron(), path("a.stl"));
  ASSERT_EQ(isostack("convert " + path("a.stl") + " -o " + path("b.ply") + " --axes ras").exit_code, 0);
  ASSERT_EQ(isostack("convert " + path("b.ply") + " -o " + path("c.ply") + " --input-axes ras").exit_code, 0);
  Eigen::Vector3d turned = Eigen::Vector3d::Zero(), back = turned;
  for (const Eigen::Vector3d& vertex : read_mesh(path("b.ply")).vertices_mm) turned += vertex / 6;
  for (const Eigen::Vector3d& vertex : read_mesh(path("c.ply")).vertices_mm) back += vertex / 6;
  EXPECT_LT((turned - Eigen::Vector3d(-1, 2, 300)).norm(), 1e-4);
  EXPECT_LT((back - Eigen::Vector3d(1, -2, 300)).norm(), 1e-4);
}

TEST_F(ConvertTest, AMeshIsCutOnTheSlicesOfAVolume) {
  StoredVolume volume = ramp();
  volume.header.grid.index_to_world.translation() = Eigen::Vector3d(-7, 8, 300);
  write_volume(volume, path("grid.nrrd"));
  write_mesh(octahedron(), path("a.stl"));
  const ProgramRun run =
      isostack("convert " + path("a.stl") + " --like " + path("grid.nrrd") + " -o " + path("b.json"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::vector<ContourStack> organs = read_contours(path("b.json"));
  ASSERT_EQ(organs.at(0).slices.size(), 2u);
  // the octahedron's section at height h is a square with half diagonals of 25 - h
  EXPECT_NEAR(signed_area_mm2(organs[0].slices[1].contours.at(0)), 2 * 22 * 22, 0.01);
}

TEST_F(ConvertTest, LinesOfAnOpenMeshThatDoNotCloseAreTold) {
  StoredVolume volume = ramp();
  volume.header.grid.index_to_world.translation() = Eigen::Vector3d(-7, 8, 300);
  write_volume(volume, path("grid.nrrd"));
  TriangleMesh open = octahedron();
  open.triangles.pop_back();
  write_mesh(open, path("open.stl"));
  const ProgramRun run =
      isostack("convert " + path("open.stl") + " --like " + path("grid.nrrd") + " -o " + path("b.json"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE((run.out + run.err).find("lines on the planes do not close"), std::string::npos) << run.out << run.err;
}

TEST_F(ConvertTest, OtherKindsAreRefusedBeforeAnythingIsWritten) {
  write_mesh(octahedron(), path("mesh.vtp"));
  write_contours(two_organs(), path("contours.vtp"));
  write_volume(ramp(), path("volume.nrrd"));
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& kind) {
    const ProgramRun run = isostack("convert " + path(from) + " -o " + path(to));
    EXPECT_EQ(run.exit_code, 3) << from << to;
    EXPECT_NE(run.err.find("cannot hold " + kind), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(path(to)));
  };
  refused("mesh.vtp", "x.json", "a mesh");
  refused("mesh.vtp", "x.nii.gz", "a mesh");
  refused("contours.vtp", "x.stl", "contours");
  refused("contours.vtp", "x.nrrd", "contours");
  refused("volume.nrrd", "x.stl", "a volume");
  EXPECT_EQ(isostack("convert " + path("missing.stl") + " -o " + path("x.ply")).exit_code, 3);
  EXPECT_EQ(isostack("convert " + path("mesh.vtp") + " -o " + path("no/x.ply")).exit_code, 3);
}

}  // namespace
}  // namespace isostack::testing_support
