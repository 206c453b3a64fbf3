// `-` in place of files: the same bytes as with files, and refusals where a stream cannot serve.
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace isostack {
namespace {

using testing_support::file_text;
using testing_support::ProgramRun;

class StandardStreams : public testing_support::SampleTest {
 protected:
  /// The program with its arguments after a pipe, such as "cat x |", its standard output in a file.
  ProgramRun piped(const std::string& before, const std::string& arguments, const std::string& into = "") const {
    std::string command = "export TMPDIR=";
    command.append(path("tmp")).append(" && { ").append(before).append(" " ISOSTACK_PROGRAM " ");
    command.append(arguments);
    if (!into.empty()) command.append(" >").append(into);
    return run_command(command.append(" ; }"));
  }
  void SetUp() override {
    SampleTest::SetUp();
    std::filesystem::create_directory(path("tmp"));
  }
  /// Nothing stays behind, however a command ends.
  void TearDown() override {
    EXPECT_TRUE(std::filesystem::is_empty(path("tmp")));
    SampleTest::TearDown();
  }
};

TEST_F(StandardStreams, PipedCommandsGiveTheBytesOfFiles) {
  const std::string segment = "segment " + path("sample/series") + " --level 25 --gaussian 1 --largest -o ";
  const std::string reconstruct = "reconstruct --max-constraints 500 --resolution 2 -o ";
  ASSERT_EQ(isostack(segment + path("contours.json")).exit_code, 0);
  ASSERT_EQ(isostack(reconstruct + path("organ.ply") + " " + path("contours.json")).exit_code, 0);
  const ProgramRun run =
      piped(ISOSTACK_PROGRAM " " + segment + "- --quiet |", reconstruct + "- - --quiet", path("piped.ply"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(file_text(path("piped.ply")), file_text(path("organ.ply")));
}

TEST_F(StandardStreams, FormatsAreNamedOrTold) {
  const std::string mesh = path("stdin.stl");  // the name that PLY keeps
  std::filesystem::copy_file(path("sample/truth.stl"), mesh);
  ASSERT_EQ(isostack("convert " + mesh + " -o " + path("truth.ply")).exit_code, 0);
  for (const std::string input : {"-", "stl:-"}) {
    const ProgramRun run = piped("cat " + mesh + " |", "convert " + input + " -o ply:-", path("piped.ply"));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "wrote -\n");
    EXPECT_EQ(file_text(path("piped.ply")), file_text(path("truth.ply")));
  }
  const ProgramRun measured = piped("cat " + mesh + " |", "measure - --json");
  EXPECT_EQ(measured.json()["shape"], isostack("measure " + mesh + " --json").json()["shape"]);
  EXPECT_EQ(measured.out.find(path("tmp")), std::string::npos);  // the temporary file is nobody's business
}

TEST_F(StandardStreams, TheReportGoesToAFile) {
  const ProgramRun run = piped("", "convert " + path("sample/truth.stl") + " -o obj:- --report " + path("report.json"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("#") || run.out.starts_with("v ")) << run.out.substr(0, 40);
  EXPECT_EQ(nlohmann::json::parse(file_text(path("report.json")))["outputs"], nlohmann::json::array({"-"}));
}

TEST_F(StandardStreams, WrongUsesAreRefused) {
  const std::string convert = "convert " + path("sample/truth.stl") + " -o ";
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"measure - --against -", "one file each"},
      {convert + "-", "needs a format"},
      {convert + "ply:- --json", "--report"},
      {convert + "ply:- --record p.json", "name files"},
  };
  for (const auto& [arguments, words] : wrong) {
    const ProgramRun run = piped("true |", arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    EXPECT_EQ(run.out.empty(), arguments.find("--json") == std::string::npos) << run.out;  // the failure as JSON
  }
}

TEST_F(StandardStreams, InputWithoutAFormatIsRefused) {
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"true", "is empty"},
      {"echo hello", "no known format"},
      {"head -c 1000 " + path("sample/truth.stl"), "no known format"},  // a binary STL shows by its size
  };
  for (const auto& [before, words] : bad) {
    const ProgramRun run = piped(before + " |", "measure -");
    EXPECT_EQ(run.exit_code, 3) << before;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
}

TEST_F(StandardStreams, SeveralOrgansDoNotFit) {
  ASSERT_EQ(isostack("segment " + path("sample/series") + " --seed -22,14.7,116.3,one --seed -22,14.7,100,two " +
                     "--range 25,1000 -o " + path("two.json"))
                .exit_code,
            0);
  const ProgramRun run =
      piped("cat " + path("two.json") + " |", "reconstruct - -o - --max-constraints 2000 --resolution 4");
  EXPECT_EQ(run.exit_code, 3) << run.err;
  EXPECT_NE(run.err.find("several files"), std::string::npos) << run.err;
  EXPECT_EQ(run.out, "");
}

}  // namespace
}  // namespace isostack
