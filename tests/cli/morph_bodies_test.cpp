// Bodies of every kind as key shapes of `isostack morph`: distance volumes, scans, meshes with flaws.
#include <gtest/gtest.h>

#include <fstream>

#include "io/meshes/read_mesh.h"
#include "io/meshes/write_mesh.h"
#include "recon/metrics/mesh_measures.h"
#include "tests/cli/program.h"
#include "tests/support/analytic_meshes.h"

namespace isostack {
namespace {

using testing_support::ProgramRun;
using testing_support::sphere_mesh;

constexpr double ball_mm3 = 33510;  // 4/3 π 20³

class MorphBodies : public testing_support::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write_mesh(sphere_mesh({0, 0, 0}, 20, 48, 24), path("ball.ply"));
    std::ofstream(path("solid.json")) << R"({"format": "isostack-solid", "version": 1,
      "solid": {"superellipsoid": {"radii_mm": [20, 20, 20]}}})";
  }
  ProgramRun morph(const std::string& shapes, const std::string& options = "") const {
    return isostack("morph --frames 2 --json --method level-set --resolution 2 " + options + " -o " + path("frames") +
                    " " + shapes);
  }
  std::string all(const std::vector<std::string>& names) const {
    std::string paths;
    for (const std::string& name : names) paths += path(name) + " ";
    return paths;
  }
};

TEST_F(MorphBodies, DistanceVolumesAreShapesWhereverShapesAre) {
  ASSERT_EQ(isostack("convert " + path("ball.ply") + " --voxel 2 -o " + path("ball.nii.gz")).exit_code, 0);
  ASSERT_EQ(isostack("convert " + path("solid.json") + " --voxel 2 -o " + path("solid.mha")).exit_code, 0);
  // A sphere of 48 × 24 quadrilaterals lacks 1 % of the ball, cells of 2 mm another half per cent.
  for (const char* name : {"ball.nii.gz", "solid.mha", "solid.json"}) {
    const ProgramRun run = isostack("measure --json " + path(name));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NEAR(run.json()["shape"]["volume_mm3"], ball_mm3, 0.02 * ball_mm3) << name;
  }
  ASSERT_EQ(isostack("convert " + path("solid.mha") + " -o " + path("again.stl")).exit_code, 0);
  EXPECT_TRUE(measure(read_mesh(path("again.stl"))).watertight());
  for (const std::string method : {"level-set", "blend", "signed-distance", "variational --max-constraints 1000"}) {
    const ProgramRun run = isostack("morph --frames 2 --resolution 3 --json -o " + path("m") + " --method " + method +
                                    " " + all({"ball.nii.gz", "solid.mha"}));
    ASSERT_EQ(run.exit_code, 0) << method << run.err;
    EXPECT_NEAR(run.json()["frames"][1]["volume_mm3"], ball_mm3, 0.05 * ball_mm3) << method;  // cells of 3 mm
  }
}

TEST_F(MorphBodies, UnmarkedDistancesNeedTheOption) {
  ASSERT_EQ(isostack("convert " + path("solid.json") + " --voxel 2 -o " + path("a.mha")).exit_code, 0);
  std::string bytes = testing_support::file_text(path("a.mha"));
  const std::size_t mark = bytes.find("Comment");
  ASSERT_NE(mark, std::string::npos);
  std::ofstream(path("bare.mha"), std::ios::binary) << bytes.erase(mark, bytes.find('\n', mark) + 1 - mark);
  EXPECT_EQ(morph(all({"ball.ply", "bare.mha"})).exit_code, 3);  // a grey volume without a rule
  EXPECT_EQ(morph(all({"ball.ply", "bare.mha"}), "--distances inside").exit_code, 0);
  // Turned over once and, without the mark, once more.
  ASSERT_EQ(isostack("convert " + path("bare.mha") + " --distances outside -o " + path("turned.mha")).exit_code, 0);
  std::string turned = testing_support::file_text(path("turned.mha"));
  const std::size_t again = turned.find("Comment");
  std::ofstream(path("t.mha"), std::ios::binary) << turned.erase(again, turned.find('\n', again) + 1 - again);
  const ProgramRun outside = isostack("measure --json --distances outside " + path("t.mha"));
  EXPECT_NEAR(outside.json()["shape"]["volume_mm3"], ball_mm3, 0.02 * ball_mm3);
  ASSERT_EQ(isostack("convert " + path("bare.mha") + " --distances inside -o " + path("b.nrrd")).exit_code, 0);
  EXPECT_EQ(morph(all({"ball.ply", "b.nrrd"})).exit_code, 0);
}

TEST_F(MorphBodies, ScansAreSegmentedInThreeDimensions) {
  ASSERT_EQ(run_command(ISOSTACK_MAKE_KEY_SHAPES " " + path("keys")).exit_code, 0);
  const ProgramRun run =
      isostack("morph " + all({"keys/head.ply", "keys/head_scan.mha", "keys/head.ply"}) +
               "--method level-set --frames 3 --resolution 6 --level -480 --volume --fill-holes --largest --json -o " +
               path("heads"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* frame : {"frame_000.stl", "frame_001.stl", "frame_002.stl"})
    EXPECT_TRUE(measure(read_mesh(path(std::string("heads/") + frame))).watertight()) << frame;
  for (const nlohmann::json& course : run.json()["courses"]) EXPECT_TRUE(course["arrived"]);
}

TEST_F(MorphBodies, FlawedMeshesAreRefusedOrMendedWithAWarning) {
  TriangleMesh open = sphere_mesh({0, 0, 0}, 20, 48, 24);
  open.triangles.resize(open.triangles.size() - 3);
  write_mesh(open, path("open.ply"));
  TriangleMesh crossing = sphere_mesh({0, 0, 0}, 20, 48, 24);
  const TriangleMesh other = sphere_mesh({18, 0, 0}, 20, 48, 24);
  const int count = static_cast<int>(crossing.vertices_mm.size());
  crossing.vertices_mm.insert(crossing.vertices_mm.end(), other.vertices_mm.begin(), other.vertices_mm.end());
  for (const Eigen::Vector3i& t : other.triangles) crossing.triangles.emplace_back(t.array() + count);
  write_mesh(crossing, path("crossing.ply"));
  for (const char* name : {"open.ply", "crossing.ply"}) {
    const ProgramRun refused = morph(all({"ball.ply", name}));
    EXPECT_EQ(refused.exit_code, 3) << name;
    EXPECT_NE(refused.err.find(name), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("mended"), std::string::npos) << refused.err;
    const ProgramRun mended = morph(all({"ball.ply", name}), "--mend");
    ASSERT_EQ(mended.exit_code, 0) << mended.err;
    EXPECT_NE(mended.err.find(std::string(name) + ": "), std::string::npos) << mended.err;
    EXPECT_GE(mended.json()["notes"].size(), 2u);
  }
  const ProgramRun told = isostack("convert --json " + path("open.ply") + " --voxel 2 -o " + path("open.mha"));
  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_NE(told.json()["notes"][0].get<std::string>().find("not closed"), std::string::npos);
}

}  // namespace
}  // namespace isostack
