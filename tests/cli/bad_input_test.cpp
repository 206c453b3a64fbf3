// Every refusal: the exit code of the contract, one sentence that names the culprit, no output left behind.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::file_text;
using testing_support::ProgramRun;

class BadInput : public testing_support::ProgramTest {
 protected:
  void make_sample() {
    ASSERT_EQ(run_command(ISOSTACK_MAKE_PHANTOM " " + path("sample")).exit_code, 0);
    series = folder / "sample" / "series";
  }
  std::filesystem::path a_slice(int number) const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(series)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files.at(static_cast<std::size_t>(number));
  }
  /// Runs reconstruct and expects a refusal that mentions all of `words`.
  void expect_refusal(const std::string& arguments, const std::vector<std::string>& words, int exit_code = 3) {
    const ProgramRun run = isostack("reconstruct " + arguments + " -o " + path("organ.stl"));
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_TRUE(run.out.empty()) << run.out;
    for (const std::string& word : words)
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " not in: " << run.err;
    EXPECT_FALSE(std::filesystem::exists(path("organ.stl")));
  }
  std::filesystem::path series;
};

TEST_F(BadInput, MissingFolder) { expect_refusal(path("nowhere") + " --level 25", {"nowhere"}); }

TEST_F(BadInput, MissingFolderIsToldBeforeAMissingRule) {
  expect_refusal(path("nowhere"), {"nowhere", "no such file"});
}

TEST_F(BadInput, EmptyFolder) {
  std::filesystem::create_directories(path("empty"));
  expect_refusal(path("empty") + " --level 25", {"empty"});
}

TEST_F(BadInput, FolderWithTwoSeriesListsThem) {
  make_sample();
  expect_refusal(path("sample") + " --level 25", {"--series", "30", "12"});
}

TEST_F(BadInput, TruncatedDicomFile) {
  make_sample();
  const std::filesystem::path victim = a_slice(4);
  std::filesystem::resize_file(victim, std::filesystem::file_size(victim) / 2);
  expect_refusal(victim.string() + " --level 25", {victim.filename().string(), "cut off or damaged"});
}

TEST_F(BadInput, TruncatedDicomFileOfAFolderIsLeftOutAndTold) {
  make_sample();
  const std::filesystem::path victim = a_slice(4);
  std::filesystem::resize_file(victim, std::filesystem::file_size(victim) / 2);
  const ProgramRun run = isostack("segment " + series.string() + " --level 25 --json -o " + path("organ.vtp"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const std::string& word : {victim.filename().string(), std::string("damaged files"), std::string("uneven gaps")})
    EXPECT_NE(run.err.find(word), std::string::npos) << word << " not in: " << run.err;
  EXPECT_EQ(run.json()["organs"][0]["slices"], 29);
  // With every file like that nothing is left.
  for (int i = 0; i < 30; ++i) std::filesystem::resize_file(a_slice(i), 900);
  expect_refusal(series.string() + " --level 25", {"30 of its DICOM files cannot be read"});
}

TEST_F(BadInput, LevelThatNoPixelCrosses) {
  make_sample();
  expect_refusal(series.string() + " --level 5000", {"5000", "level"});
}

TEST_F(BadInput, OneSliceOnly) {
  make_sample();
  expect_refusal(a_slice(15).string() + " --level 25", {"slice", "two"});
  expect_refusal(series.string() + " --level 25 --slices 15", {"slice", "two"});
}

TEST_F(BadInput, OpenContour) {
  std::ofstream(path("open.json"))
      << R"({"format": "isostack-contours", "version": 1, "organs": [{"name": "liver", "slices": [
    {"name": "slice 7", "pose": {"origin_mm": [0,0,0], "x_axis": [1,0,0], "y_axis": [0,1,0], "spacing_mm": [1,1]},
     "size_pixels": [0,0], "contours": [{"points_mm": [[0,0],[5,0]]}]}]}]})";
  expect_refusal(path("open.json"), {"open.json", "slice 7"});
}

TEST_F(BadInput, GreyImagesWithoutARule) {
  make_sample();
  expect_refusal(series.string(), {"--level", "--label"});
}

TEST_F(BadInput, UnknownOutputIsRefusedBeforeAnyWork) {
  make_sample();
  const ProgramRun run = isostack("reconstruct " + series.string() + " --level 25 -o " + path("organ.xyz"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find(".stl"), std::string::npos) << run.err;
}

TEST_F(BadInput, TooLittleMemoryIsToldBeforeTheSolve) {
  make_sample();
  expect_refusal(series.string() + " --level 25 --memory 0.01", {"--memory", "GB"}, 4);
}

TEST_F(BadInput, WrongUsage) {
  EXPECT_EQ(isostack("").exit_code, 2);
  EXPECT_EQ(isostack("reconstruct").exit_code, 2);
  EXPECT_EQ(isostack("reconstruct x --levle 3 -o y.stl").exit_code, 2);
  EXPECT_EQ(isostack("reconstruct x --level 3 --label 4 -o y.stl").exit_code, 2);
}

TEST_F(BadInput, HelpSaysWhatItIsNot) {
  const ProgramRun run = isostack("--help");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("not for clinical use"), std::string::npos);
}

TEST_F(BadInput, NoDisplay) {
  make_sample();
  const ProgramRun run = run_command("env -u DISPLAY " ISOSTACK_PROGRAM " view " + path("sample/truth.stl") +
                                     " --screenshot " + path("p.png"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("xvfb-run"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(path("p.png")));
}

}  // namespace
}  // namespace isostack
