// `isostack morph` as people call it: what comes in, what comes out, what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "io/contours/contour_files.h"
#include "io/images/image_stack.h"
#include "io/images/write_pictures.h"
#include "recon/geometry/contour.h"
#include "tests/cli/program.h"
#include "tests/support/gif_blocks.h"

namespace isostack {
namespace {

namespace fs = std::filesystem;
using testing_support::file_text;
using testing_support::ProgramRun;

class MorphTest : public testing_support::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    ASSERT_EQ(run_command(ISOSTACK_MAKE_SHAPES " " + path("shapes")).exit_code, 0);
  }
  std::string shape(const std::string& name) const { return path("shapes/" + name); }
  /// Everything in the test's folder but the shapes, hidden files included.
  std::vector<std::string> left_behind() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().filename() != "shapes") names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  static std::size_t files_in(const fs::path& of) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(of), fs::directory_iterator()));
  }
  static std::vector<Contour> only_contours(const fs::path& file) {
    const std::vector<ContourStack> organs = read_contours(file);
    EXPECT_EQ(organs.size(), 1u);
    EXPECT_EQ(organs.front().slices.size(), 1u);
    return organs.front().slices.front().contours;
  }
  static double farthest_mm(const std::vector<Contour>& of, const std::vector<Contour>& from) {
    double farthest = 0;
    for (const Contour& contour : of)
      for (const Eigen::Vector2d& point : contour.points_mm)
        farthest = std::max(farthest, std::abs(signed_distance_mm(from, point)));
    return farthest;
  }
};

TEST_F(MorphTest, EndFramesAreTheGivenFigures) {
  for (const std::string method : {"variational", "signed-distance"}) {
    const ProgramRun run = isostack("morph " + shape("x.png") + " " + shape("o.png") + " --method " + method +
                                    " --frames 3 --format json -o " + path(method));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(files_in(path(method)), 3u);
    for (const auto& [name, file] : {std::pair{"x", "frame_000.json"}, std::pair{"o", "frame_002.json"}}) {
      const std::string truth = path(std::string(name) + ".json");
      ASSERT_EQ(isostack("segment " + shape(std::string(name) + ".png") + " --spacing 1,1,1 --level 127.5 -o " + truth)
                    .exit_code,
                0);
      const std::vector<Contour> given = only_contours(truth), frame = only_contours(fs::path(path(method)) / file);
      EXPECT_LT(farthest_mm(given, frame), 0.1) << method << ' ' << name;  // a tenth of a pixel
      EXPECT_LT(farthest_mm(frame, given), 0.1) << method << ' ' << name;
    }
  }
}

TEST_F(MorphTest, FiguresGoToEveryKindOfOutputWithoutADisplay) {
  const ProgramRun run = run_command("env -u DISPLAY " ISOSTACK_PROGRAM " morph " + shape("x.png") + " " +
                                     shape("o.png") + " --frames 7 --size 96 --json --report " + path("r.json") +
                                     " -o " + path("frames/") + " -o " + path("a.gif") + " -o " + path("sheet.png") +
                                     " -o " + path("c.vtp") + " -o " + path("s.stl") + " --plot " + path("q.svg"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(left_behind(),
            (std::vector<std::string>{"a.gif", "c.vtp", "frames", "q.svg", "r.json", "s.stl", "sheet.png"}));
  EXPECT_EQ(run.json()["outputs"].size(), 6u);
  EXPECT_EQ(files_in(path("frames")), 7u);
  const ImageInfo first = image_info(path("frames/frame_000.png"));
  EXPECT_EQ(std::max(first.columns, first.rows), 96);
  EXPECT_EQ(testing_support::gif_blocks(path("a.gif")).pictures, 7);
  EXPECT_GT(image_info(path("sheet.png")).columns, 7 * first.columns);
  EXPECT_NE(file_text(path("q.svg")).find("Curvature"), std::string::npos);

  const std::vector<ContourStack> stack = read_contours(path("c.vtp"));
  ASSERT_EQ(stack.front().slices.size(), 7u);
  const double spacing_mm = run.json()["spacing_mm"];
  EXPECT_NEAR(stack.front().slices.back().pose.origin_mm.z(), spacing_mm, 1e-9);
  // The surface that the frames sweep is open at its ends, and has the volume of their areas along t (Simpson's rule).
  const nlohmann::json surface = isostack("measure " + path("s.stl") + " --json").json()["shape"];
  EXPECT_EQ(surface["components"], 2);  // outside, and in the hole
  EXPECT_EQ(surface["non_manifold_edges"], 0);
  double sum = 0;
  const nlohmann::json frames = run.json()["frames"];
  for (std::size_t i = 0; i < 7; ++i)
    sum += (i == 0 || i == 6 ? 1 : i % 2 == 1 ? 4 : 2) * frames[i]["area_mm2"].get<double>();
  // What an open mesh has is the sum of the cones over its triangles from the origin, which lies in the plane of one
  // end.
  const double other_end_mm3 = spacing_mm * frames[6]["area_mm2"].get<double>() / 3;
  EXPECT_NEAR(surface["volume_mm3"].get<double>() + other_end_mm3, sum * spacing_mm / 18, 0.02 * sum * spacing_mm / 18);
}

TEST_F(MorphTest, TellsWhatEveryFrameIs) {
  const ProgramRun run =
      isostack("morph " + shape("x.png") + " " + shape("o.png") + " --at 0,0.5,1 --json -o " + path("a.json"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json result = run.json();
  EXPECT_EQ(result["method"], "variational");
  EXPECT_GT(result["constraints"], 300);
  EXPECT_EQ(result["converged"], true);
  ASSERT_EQ(result["frames"].size(), 3u);
  EXPECT_EQ(result["frames"][1]["t"], 0.5);
  EXPECT_EQ(result["frames"][0]["components"], 1);
  EXPECT_EQ(result["frames"][0]["holes"], 0);
  EXPECT_EQ(result["frames"][2]["holes"], 1);
  const double ring_mm2 = 3.14159265 * (38 * 38 - 20 * 20);
  EXPECT_NEAR(result["frames"][2]["area_mm2"].get<double>(), ring_mm2, 0.005 * ring_mm2);
  // A right angle turns by 2 sin(45°) within a pixel; a disc of 38 mm hardly, but its pixels are of 8 bits.
  EXPECT_GT(result["frames"][0]["curvature_per_mm"]["highest"].get<double>(), 1);
  EXPECT_LT(result["frames"][2]["curvature_per_mm"]["highest"].get<double>(), 0.3);
  EXPECT_FALSE(result["topology_changes"].empty());
}

TEST_F(MorphTest, ThreeFiguresOnALineAndOnATriangle) {
  const std::string three = shape("x.png") + " " + shape("star.png") + " " + shape("o.png");
  const ProgramRun line = isostack("morph " + three + " --times 0,0.2,1 --at 0.2 --format json -o " + path("line"));
  ASSERT_EQ(line.exit_code, 0) << line.err;
  ASSERT_EQ(
      isostack("segment " + shape("star.png") + " --spacing 1,1,1 --level 127.5 -o " + path("star.json")).exit_code, 0);
  // A tenth of a pixel but at the tips of 37 degrees, which a lattice of pixels cuts.
  EXPECT_LT(farthest_mm(only_contours(path("line/frame_000.json")), only_contours(path("star.json"))), 0.15);

  const ProgramRun triangle =
      isostack("morph " + three + " --path \"1,0,0;0,1,0;0,0,1\" --frames 5 --format json --json -o " + path("path"));
  ASSERT_EQ(triangle.exit_code, 0) << triangle.err;
  EXPECT_LT(farthest_mm(only_contours(path("path/frame_002.json")), only_contours(path("star.json"))), 0.15);
  EXPECT_EQ(triangle.json()["frames"][1]["weights"], nlohmann::json({0.5, 0.5, 0.0}));
}

TEST_F(MorphTest, ARecipeDoesItAgain) {
  const std::string out = " --frames 4 --spacing 20 --recipe turk-obrien -o " + path("a.json") + " -o " + path("a.gif");
  ASSERT_EQ(
      isostack("morph " + shape("x.png") + " " + shape("o.png") + out + " --save-recipe " + path("r.json")).exit_code,
      0);
  const std::string contours = file_text(path("a.json")), gif = file_text(path("a.gif"));
  fs::remove(path("a.json"));
  fs::remove(path("a.gif"));
  const ProgramRun again = isostack("run " + path("r.json"));
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(file_text(path("a.json")), contours);
  EXPECT_EQ(file_text(path("a.gif")), gif);
}

TEST_F(MorphTest, SlicesMakeABodyAndOneOfThemAFigure) {
  // A cone's frustum in squares of 40 down to 24 mm, 5 mm apart.
  std::ostringstream slices;
  for (int k = 0; k < 5; ++k) {
    const int a = 2 * k, b = 40 - 2 * k;
    slices << (k == 0 ? "" : ",") << R"({"name": "slice", "pose": {"origin_mm": [-20,-20,)" << 5 * k - 10
           << R"(], "x_axis": [1,0,0], "y_axis": [0,1,0], "spacing_mm": [1,1]}, "size_pixels": [0,0],
                 "contours": [{"points_mm": [[)"
           << a << ',' << a << "],[" << b << ',' << a << "],[" << b << ',' << b << "],[" << a << ',' << b << "]]}]}";
  }
  std::ofstream(path("frustum.json"))
      << R"({"format": "isostack-contours", "version": 1, "organs": [{"name": "frustum", "slices": [)" << slices.str()
      << "]}]}";
  const ProgramRun bodies = isostack("morph " + path("frustum.json") + " " + shape("sphere.ply") +
                                     " --max-constraints 1500 --resolution 3 --frames 2 --json -o " + path("bodies"));
  ASSERT_EQ(bodies.exit_code, 0) << bodies.err;
  const nlohmann::json first = bodies.json()["frames"][0];
  EXPECT_EQ(first["watertight"], true);
  EXPECT_GT(first["volume_mm3"].get<double>(), 20 * 1041.0);  // that between its slices; its ends are rounded beyond
  EXPECT_LT(first["volume_mm3"].get<double>(), 25 * 1600.0);

  const std::string one = "morph " + path("frustum.json") + " " + path("frustum.json") + " --frames 2 --json ";
  const ProgramRun figures = isostack(one + "--slices 1 -o " + path("a.json"));
  ASSERT_EQ(figures.exit_code, 0) << figures.err;
  EXPECT_EQ(figures.json()["shapes"][0]["dimension"], 2);
  EXPECT_NEAR(figures.json()["frames"][1]["area_mm2"].get<double>(), 36 * 36, 13);  // corners are cut: a hundredth
}

TEST_F(MorphTest, BodiesBecomeClosedMeshes) {
  const ProgramRun run = isostack("morph " + shape("sphere.ply") + " " + shape("torus.ply") +
                                  " --max-constraints 2000 --resolution 3 --frames 3 --json -o " + path("m.stl"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(left_behind(), (std::vector<std::string>{"m_000.stl", "m_001.stl", "m_002.stl"}));
  const nlohmann::json frames = run.json()["frames"];
  for (const nlohmann::json& frame : frames) EXPECT_EQ(frame["watertight"], true);
  EXPECT_EQ(frames[0]["genus"], 0);
  EXPECT_EQ(frames[2]["genus"], 1);
  EXPECT_NEAR(frames[0]["volume_mm3"].get<double>(), 4.18879 * 27000, 0.02 * 4.18879 * 27000);
  EXPECT_NEAR(frames[0]["mean_curvature_per_mm"]["p99"].get<double>(), 1.0 / 30, 0.3 / 30);
}

}  // namespace
}  // namespace isostack
