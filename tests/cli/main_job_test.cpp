// The whole path on the generated sample: DICOM in, one closed surface out.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::file_text;
using testing_support::ProgramRun;

class MainJob : public testing_support::SampleTest {
 protected:
  void SetUp() override {
    SampleTest::SetUp();
    truth = nlohmann::json::parse(file_text(path("sample/truth.json")));
  }
  nlohmann::json truth;
};

TEST_F(MainJob, SeriesToClosedSurfaceNearTheTruth) {
  const ProgramRun run = isostack("reconstruct " + path("sample/series") +
                                  " --level 25 --curvature 1 --largest --max-constraints 5000 -o " + path("organ.stl") +
                                  " --json --report " + path("report.json"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json surface = run.json()["surfaces"][0]["surface"];
  EXPECT_TRUE(surface["watertight"]);
  EXPECT_EQ(surface["components"], 1);
  EXPECT_EQ(surface["genus"], 0);
  EXPECT_EQ(nlohmann::json::parse(file_text(path("report.json"))), run.json());

  const ProgramRun compared =
      isostack("measure " + path("organ.stl") + " --against " + path("sample/truth.stl") + " --json");
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  const nlohmann::json comparison = compared.json()["comparison"];
  EXPECT_GT(comparison["dice"], 0.97);
  EXPECT_LT(comparison["mean_distance_mm"], 0.4);  // 1 mm pixels with noise, gaps up to 5 mm
  const double volume = truth["volume_mm3"];
  EXPECT_NEAR(compared.json()["shape"]["volume_mm3"], volume, 0.03 * volume);
}

TEST_F(MainJob, ReportTellsHowItWasSolved) {
  for (const std::string solver : {"dense", "fast"}) {
    const ProgramRun run =
        isostack("reconstruct " + path("sample/series") + " --level 25 --largest --max-constraints 2000 --solver " +
                 solver + " -o " + path("organ.stl") + " --json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const nlohmann::json report = run.json()["surfaces"][0];
    EXPECT_EQ(report["solver"], solver);
    EXPECT_TRUE(report["converged"]);
    EXPECT_LE(report["largest_residual_mm"], report["tolerance_mm"]);
    EXPECT_EQ(report["iterations"] > 0, solver == "fast");
    EXPECT_GT(report["predicted_bytes"], 8 * report["constraints"].get<int>());
    EXPECT_GT(report["peak_bytes"], 1'000'000);  // of the whole process
    double seconds = 0;
    for (const nlohmann::json& stage : report["solve_stages"]) {
      EXPECT_GE(stage["bytes"], 0);
      seconds += stage["seconds"].get<double>();
    }
    EXPECT_GT(seconds, 0);
    EXPECT_LE(seconds, report["seconds"]["solve"]);
  }
}

TEST_F(MainJob, NonParallelPlanesGiveTheSameOrgan) {
  const ProgramRun run =
      isostack("reconstruct " + path("sample/planes") + " --level 25 --curvature 1 --max-constraints 4000 -o " +
               path("organ.ply") + " --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const ProgramRun compared =
      isostack("measure " + path("organ.ply") + " --against " + path("sample/truth.stl") + " --json");
  EXPECT_GT(compared.json()["comparison"]["dice"], 0.9);  // twelve planes through four branches
}

TEST_F(MainJob, ContoursInBetweenAndLabelsOutAgree) {
  ASSERT_EQ(
      isostack("segment " + path("sample/series") + " --level 25 --largest -o " + path("contours.json")).exit_code, 0);
  const ProgramRun from_contours =
      isostack("reconstruct " + path("contours.json") + " --max-constraints 2000 -o " + path("a.vtp") + " --json");
  const ProgramRun from_images =
      isostack("reconstruct " + path("sample/series") + " --level 25 --largest --max-constraints 2000 -o " +
               path("b.vtp") + " --json");
  ASSERT_EQ(from_contours.exit_code, 0) << from_contours.err;
  const double a = from_contours.json()["surfaces"][0]["surface"]["volume_mm3"];
  const double b = from_images.json()["surfaces"][0]["surface"]["volume_mm3"];
  EXPECT_NEAR(a, b, 1e-6 * b);  // the same contours, through text with full precision
}

TEST_F(MainJob, OptionsOfThePaperWork) {
  const ProgramRun run =
      isostack("reconstruct " + path("sample/series") + " --level 25 --preset turk-obrien --max-constraints 3000 -o " +
               path("organ.obj") + " --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.json()["surfaces"][0]["surface"]["watertight"]);
}

TEST_F(MainJob, EverySecondSliceHalvesTheInput) {
  const ProgramRun run =
      isostack("segment " + path("sample/series") + " --level 25 --every 2 -o " + path("c.vtp") + " --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json()["organs"][0]["slices"], 15);
}

TEST_F(MainJob, PictureShowsTheSurface) {
  if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "no display; run the tests under xvfb-run";
  const ProgramRun run =
      isostack("view " + path("sample/truth.stl") + " --screenshot " + path("picture.png") + " --size 320,240");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_GT(std::filesystem::file_size(path("picture.png")), 2000u);  // an empty picture compresses to less
}

TEST_F(MainJob, InterruptedRunLeavesNoOutput) {
  // The solve of 9,000 constraints outlasts the wait on any machine; TERM stands for Ctrl-C, which
  // a shell keeps from background jobs.
  const ProgramRun run =
      run_command("timeout --preserve-status -s TERM 1.5 " ISOSTACK_PROGRAM " reconstruct " + path("sample/series") +
                  " --level 25 --max-constraints 20000 --threads 1 -o " + path("organ.stl"));
  EXPECT_EQ(run.exit_code, 5) << run.err;
  EXPECT_FALSE(std::filesystem::exists(path("organ.stl")));
  for (const auto& entry : std::filesystem::directory_iterator(folder)) EXPECT_EQ(entry.path().filename(), "sample");
}

}  // namespace
}  // namespace isostack
