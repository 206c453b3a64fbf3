// What `isostack morph` refuses: the exit code of the contract, one sentence that names the culprit, nothing left.
#include <gtest/gtest.h>

#include <fstream>

#include "io/images/write_pictures.h"
#include "tests/cli/program.h"

namespace isostack {
namespace {

namespace fs = std::filesystem;
using testing_support::ProgramRun;

class MorphRefusals : public testing_support::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    ASSERT_EQ(run_command(ISOSTACK_MAKE_SHAPES " " + path("shapes")).exit_code, 0);
    fs::create_directory(path("out"));
  }
  std::string shape(const std::string& name) const { return path("shapes/" + name); }
  std::string figures() const { return shape("x.png") + " " + shape("o.png"); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  void expect_refusal(const std::string& arguments, const std::vector<std::string>& words, int exit_code = 3) const {
    const ProgramRun run =
        isostack("morph " + arguments + " --frames 3 -o " + path("out/frames") + " -o " + path("out/sheet.png"));
    EXPECT_EQ(run.exit_code, exit_code) << arguments << '\n' << run.err;
    EXPECT_TRUE(run.out.empty()) << run.out;
    for (const std::string& word : words)
      EXPECT_NE(run.err.find(word), std::string::npos) << word << " not in: " << run.err;
    EXPECT_TRUE(fs::is_empty(path("out"))) << arguments;
  }
  void landmarks(const std::string& list) const {
    write("l.json", R"({"format": "isostack-landmarks", "version": 1, "landmarks": [)" + list + "]}");
  }
  /// A square of 10 mm in the plane z = `z_mm`.
  void write_square(const std::string& name, double z_mm, const std::string& x_axis = "[1,0,0]") const {
    write(name, R"({"format": "isostack-contours", "version": 1, "organs": [{"name": "square", "slices": [
      {"name": "slice", "pose": {"origin_mm": [0,0,)" +
                    std::to_string(z_mm) + R"(], "x_axis": )" + x_axis + R"(, "y_axis": [0,1,0], "spacing_mm": [1,1]},
       "size_pixels": [0,0], "contours": [{"points_mm": [[0,0],[10,0],[10,10],[0,10]]}]}]}]})");
  }
};

TEST_F(MorphRefusals, ShapesThatDoNotFitTogether) {
  expect_refusal(shape("x.png") + " " + shape("sphere.ply"), {"sphere.ply"});
  write_square("a.json", 0);
  write_square("b.json", 7);
  expect_refusal(path("a.json") + " " + path("b.json"), {"b.json", "plane"});
  write_square("c.json", 0, "[0,0,1]");
  expect_refusal(path("a.json") + " " + path("c.json"), {"c.json"});
}

TEST_F(MorphRefusals, ShapesThatAreNone) {
  expect_refusal(shape("x.png") + " " + path("nowhere.png"), {"nowhere.png"});
  write("open.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
  expect_refusal(shape("sphere.ply") + " " + path("open.obj"), {"open.obj", "close the mesh"});
  write_png(Image<std::uint8_t>(Image<std::uint8_t>::Constant(20, 30, 77)), path("empty.png"));
  expect_refusal(shape("x.png") + " " + path("empty.png"), {"empty.png", "77"});
  expect_refusal(figures() + " --level 400", {"x.png", "400"});
}

TEST_F(MorphRefusals, Landmarks) {
  const std::string with = figures() + " --landmarks " + path("l.json");
  landmarks(R"({"from_mm": [20,20,0], "to_mm": [30,15,0]}, {"from_mm": [900,20,0], "to_mm": [47,80,0]})");
  expect_refusal(with, {"landmark", "outside"});
  landmarks(R"({"from_mm": [20,20,0], "to_mm": [30,15,0]}, {"from_mm": [20,20,0], "to_mm": [47,80,0]})");
  expect_refusal(with, {"landmark"});
  landmarks(R"({"from_mm": [20,20,5], "to_mm": [30,15,0]})");
  expect_refusal(with, {"landmark", "plane"});
  landmarks(R"({"from_mm": [20,20], "to_mm": [30,15,0]})");
  expect_refusal(with, {"l.json", "landmark 1", "from_mm"});
  landmarks("");
  expect_refusal(with, {"l.json", "no landmarks"});
  write("l.json", "{]");
  expect_refusal(with, {"l.json", "JSON"});
}

TEST_F(MorphRefusals, PlacesAndTimes) {
  expect_refusal(figures() + " --path \"1,0,0;0,1,0\"", {"--path", "2 weights"});
  expect_refusal(figures() + " --path \"1,x;0,1\"", {"--path"});
  expect_refusal(figures() + " --path \"0.5,0.6;0,1\"", {"weights"});
  expect_refusal(figures() + " --path \"1,0;0,1\" --plot " + path("out/q.svg") + " -o " + path("out/s.stl"),
                 {"--path"});
  expect_refusal(figures() + " --times 0", {"--times"});
  expect_refusal(figures() + " --times 1,0", {"time"});
}

TEST_F(MorphRefusals, OutputsBeforeAnyWork) {
  expect_refusal(figures() + " -o " + path("a.xyz"), {"a.xyz", ".gif"});
  expect_refusal(figures() + " -o " + path("nowhere/a.gif"), {"nowhere"});
  expect_refusal(figures() + " -o " + path("shapes"), {"shapes", "not a frame"});
  expect_refusal(figures() + " --format stl", {"--format stl"});
  expect_refusal(figures() + " --plot " + path("q.png"), {"q.png", ".svg"});
  expect_refusal(shape("sphere.ply") + " " + shape("torus.ply") + " -o " + path("a.json"), {"a.json", "bodies"});
}

TEST_F(MorphRefusals, WrongUsage) {
  expect_refusal(figures() + " --method magic", {"magic"}, 2);
  expect_refusal(shape("x.png"), {"two shapes"}, 2);
  expect_refusal(figures() + " --at 0.5", {"--frames"}, 2);
  expect_refusal(figures() + " --method signed-distance --spacing 3", {"spacing"}, 2);
}

TEST_F(MorphRefusals, TooLittleMemoryAndNoDisplay) {
  const std::string bodies = shape("sphere.ply") + " " + shape("torus.ply");
  expect_refusal(bodies + " --max-constraints 3000 --memory 0.0001", {"memory"}, 4);
  const ProgramRun run = run_command("env -u DISPLAY " ISOSTACK_PROGRAM " morph " + bodies +
                                     " --max-constraints 300 --resolution 6 --frames 2 -o " + path("out/a.gif"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("xvfb-run"), std::string::npos) << run.err;
  EXPECT_TRUE(fs::is_empty(path("out")));
}

TEST_F(MorphRefusals, CtrlCLeavesWhatWasThere) {
  ASSERT_EQ(isostack("morph " + figures() + " --frames 2 -o " + path("out/frames")).exit_code, 0);
  const ProgramRun run =
      run_command("timeout --preserve-status -s INT 1.5 " ISOSTACK_PROGRAM " morph " + shape("star.ply") + " " +
                  shape("knot.ply") + " --resolution 0.5 --frames 500 --format stl -o " + path("out/frames"));
  EXPECT_EQ(run.exit_code, 5) << run.err;
  EXPECT_TRUE(fs::exists(path("out/frames/frame_001.png")));
  EXPECT_EQ(std::distance(fs::directory_iterator(path("out")), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace isostack
