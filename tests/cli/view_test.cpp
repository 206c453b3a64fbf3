// `view` without a window: what it writes and what it refuses.
#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::file_text;
using testing_support::ProgramRun;

class View : public testing_support::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    std::ofstream(path("box.obj"))
        << "v 0 0 0\nv 40 0 0\nv 40 30 0\nv 0 30 0\nv 0 0 20\nv 40 0 20\nv 40 30 20\nv 0 30 20\n"
           "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";
  }
  bool has_display() const { return std::getenv("DISPLAY") != nullptr; }
};

TEST_F(View, WritesAPageWithoutADisplay) {
  const ProgramRun run = run_command("env -u DISPLAY " ISOSTACK_PROGRAM " view " + path("box.obj") + " --html " +
                                     path("box.html") + " --colour curvature --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json()["outputs"][0], path("box.html"));
  const std::string page = file_text(path("box.html"));
  EXPECT_NE(page.find("24 ml"), std::string::npos);  // 40 x 30 x 20 mm, in the title
  EXPECT_NE(page.find("mean curvature, 1/mm"), std::string::npos);
}

TEST_F(View, ShowsSolidsAndDistanceVolumes) {
  std::ofstream(path("ball.json"))
      << R"({"format": "isostack-solid", "version": 1, "solid": {"superellipsoid": {"radii_mm": [10, 10, 10]}}})";
  ASSERT_EQ(isostack("convert " + path("ball.json") + " --voxel 0.5 -o " + path("ball.nrrd")).exit_code, 0);
  for (const char* ball : {"ball.json", "ball.nrrd"}) {
    const ProgramRun run = isostack("view " + path(ball) + " --html " + path("ball.html"));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string page = file_text(path("ball.html"));
    EXPECT_NE(page.find("4.18"), std::string::npos) << ball;  // of 4.189 ml: a polyhedron within the ball
  }
}

TEST_F(View, WithoutADisplaySaysHowToDraw) {
  const ProgramRun run =
      run_command("env -u DISPLAY " ISOSTACK_PROGRAM " view " + path("box.obj") + " --screenshot " + path("box.png"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("xvfb-run"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path("box.png")));
}

TEST_F(View, RefusesOutputsBeforeReading) {
  const std::string view = "view " + path("box.obj") + " --screenshot ";
  EXPECT_EQ(isostack(view + path("no/box.png")).exit_code, 3);
  EXPECT_EQ(isostack(view + path("box.jpg")).exit_code, 3);
  EXPECT_EQ(isostack(view + path("box.png") + " --size 10").exit_code, 3);
  EXPECT_EQ(isostack(view + path("turn.mp4") + " --turntable 4").exit_code, 3);
  EXPECT_EQ(isostack(view + path("box.png") + " --camera sideways").exit_code, 2);
  EXPECT_EQ(isostack(view + path("box.png") + " --montage --turntable 3").exit_code, 2);
  EXPECT_EQ(isostack(view + path("box.png") + " --colour distance").exit_code, 3);
  EXPECT_EQ(isostack(view + path("box.png") + " --colour residual").exit_code, 3);
  EXPECT_EQ(isostack(view + path("box.png") + " --contradiction").exit_code, 3);
}

TEST_F(View, NotesAMeshInMetres) {
  std::ofstream(path("metres.obj"))
      << "v 0 0 0\nv 0.04 0 0\nv 0 0.03 0\nv 0 0 0.02\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const ProgramRun run = isostack("view " + path("metres.obj") + " --html " + path("metres.html"));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("metres"), std::string::npos);
}

TEST_F(View, WritesTurntablesAsAnAnimationOrAFolder) {
  if (!has_display()) GTEST_SKIP() << "no DISPLAY: run the tests under xvfb-run";
  const std::string view = "view " + path("box.obj") + " --size 100x80 --camera anterior --turntable 3 --screenshot ";
  ASSERT_EQ(isostack(view + path("turn.gif")).exit_code, 0);
  EXPECT_EQ(file_text(path("turn.gif")).substr(0, 6), "GIF89a");
  ASSERT_EQ(isostack(view + path("turn")).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("turn/frame_002.png")));
  EXPECT_FALSE(std::filesystem::exists(path("turn/frame_003.png")));
}

}  // namespace
}  // namespace isostack
