// The page to share: whole in itself, and shown by a browser as it should be.
#include "viewers/page/page.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <span>

#include "recon/geometry/errors.h"
#include "tests/support/analytic_meshes.h"
#include "viewers/page/base64.h"

namespace isostack {
namespace {

using testing_support::sphere_mesh;

/// A ball with values, a ring about it, two images, a mark; a name that tries to end the script it stands in.
Scene small_scene() {
  Scene scene{.title = "ball.stl\n33.5 ml", .surfaces = {{.mesh = sphere_mesh({10, 20, 30}, 20, 64, 32)}}};
  scene.surfaces[0].mesh.name = "ball</script><b>";
  scene.surfaces[0].values = VertexValues{.label = "distance, mm",
                                          .values = std::vector<double>(scene.surfaces[0].mesh.vertices_mm.size(), 1.0),
                                          .range = {.low = 0, .high = 2}};
  ContourStack ring{.name = "ring", .slices = {ContourSlice{}}};
  ring.slices[0].pose.origin_mm = {10, 20, 30};
  ring.slices[0].contours = {{.points_mm = {{25, 0}, {0, 25}, {-25, 0}, {0, -25}}}};
  scene.contours = {{.stack = ring}};
  for (const double z : {20.0, 40.0}) {
    Slice slice{.name = "DOE^JOHN", .pose = {}, .pixels = Image<float>::Constant(30, 20, 7)};
    slice.pixels(0, 0) = 0;
    slice.pose.origin_mm = {0, 5, z};
    scene.slices.push_back({.image = slice, .visible = z < 30});
  }
  scene.marks = {{.from_mm = {10, 20, 30}, .to_mm = {30, 20, 30}, .text = "20 mm"}};
  return scene;
}

nlohmann::json scene_in(const std::string& page) {
  const std::string head = "<script id=\"scene\" type=\"application/json\">";
  const std::size_t from = page.find(head) + head.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(Base64, IsThatOfTheStandard) {
  const auto encoded = [](std::string_view text) { return base64(std::as_bytes(std::span(text))); };
  // RFC 4648, section 10
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(Page, HoldsTheSceneAndNothingThatNamesItsImages) {
  const std::string page = page_html(small_scene());
  const nlohmann::json scene = scene_in(page);
  EXPECT_EQ(scene["surfaces"].size(), 1U);
  EXPECT_EQ(scene["contours"][0]["name"], "ring");
  EXPECT_EQ(scene["surfaces"][0]["name"], "ball</script><b>");
  EXPECT_EQ(scene["slices"].size(), 2U);
  EXPECT_EQ(scene["slices"][0]["png"].get<std::string>().substr(0, 26), "data:image/png;base64,iVBO");
  EXPECT_EQ(page.find("DOE"), std::string::npos);  // names of slices may come from patients
}

TEST(Page, AsksForNothingElse) {
  const std::string page = page_html(small_scene());
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_FALSE(std::regex_search(page.substr(0, 3000), std::regex("<(link|script|img|iframe)[^>]*(src|href)=")));
  EXPECT_EQ(page.find("/*scene*/"), std::string::npos);  // every part is filled in
  EXPECT_EQ(page.find("/*three.js*/"), std::string::npos);
}

TEST(Page, LargeSurfacesAndImagesAreMadeSmaller) {
  const Scene scene = small_scene();
  const std::string page = page_html(scene, {.most_triangles = 500, .most_image_pixels = 300});
  EXPECT_LT(scene_in(page)["surfaces"][0]["triangles"].get<std::string>().size(),
            scene.surfaces[0].mesh.triangles.size() * 4);  // 12 bytes a triangle are 16 characters
}

TEST(Page, RefusesNothingToShow) { EXPECT_THROW(page_html({}), InputError); }

/// What a script sees in the page: pixels that differ from the ground, before and after each layer is switched off.
constexpr const char* probe = R"(<script>
const canvas = document.querySelector('canvas'), copy = document.createElement('canvas').getContext('2d');
function ink() {
  copy.canvas.width = canvas.width; copy.canvas.height = canvas.height;
  copy.drawImage(canvas, 0, 0);
  const p = copy.getImageData(0, 0, canvas.width, canvas.height).data;
  let count = 0, green = 0;
  for (let i = 0; i < p.length; i += 4) {
    if (p[i] < 250 || p[i + 1] < 250 || p[i + 2] < 250) ++count;
    if (p[i + 1] > p[i] + 40 && p[i + 2] > p[i] + 25) ++green;
  }
  return [count, green];
}
setTimeout(() => {
  const seen = [ink()];
  for (const id of ['surface-0', 'contours-0', 'images-0', 'mark-0']) { document.getElementById(id).click(); seen.push(ink()); }
  document.getElementById('surface-0').click();
  document.getElementById('view-S').click();
  seen.push(ink());
  const out = document.createElement('p');
  out.id = 'probe';
  out.textContent = JSON.stringify({ seen: seen, state: document.body.dataset.state, bars: document.querySelectorAll('.bar').length,
    requests: performance.getEntriesByType('resource').filter((e) => !e.name.startsWith('data:') && !e.name.startsWith('blob:')).length });
  document.body.appendChild(out);
}, 500);
</script>)";

std::string browser() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
    if (std::system((std::string("command -v ") + name + " >/dev/null 2>&1").c_str()) == 0) return name;
  return "";
}

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t read = std::fread(buffer.data(), 1, buffer.size(), pipe.get()))
    text.append(buffer.data(), read);
  return text;
}

TEST(PageInABrowser, ShowsTheSceneSwitchesLayersAndAsksNoNetwork) {
  const std::string program = browser();
  if (program.empty()) GTEST_SKIP() << "no chromium: install it to see pages tested";
  const auto folder = std::filesystem::path(testing::TempDir()) / ("isostack_page_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::string page = page_html(small_scene());
  page.insert(page.rfind("</body>"), probe);
  std::ofstream(folder / "page.html") << page;
  const std::string dom = output_of("HOME=" + folder.string() + " timeout 60 " + program +
                                    " --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader "
                                    "--window-size=600,500 --user-data-dir=" +
                                    (folder / "profile").string() + " --virtual-time-budget=5000 --dump-dom file://" +
                                    (folder / "page.html").string() + " 2>/dev/null");
  std::filesystem::remove_all(folder);
  std::smatch found;
  ASSERT_TRUE(std::regex_search(dom, found, std::regex("<p id=\"probe\">([^<]*)</p>"))) << dom.size();
  const nlohmann::json result = nlohmann::json::parse(found[1].str());
  EXPECT_EQ(result["state"], "ready");
  EXPECT_EQ(result["requests"], 0);
  const auto ink = [&](std::size_t i) { return result["seen"][i][0].get<int>(); };
  const auto green = [&](std::size_t i) { return result["seen"][i][1].get<int>(); };
  EXPECT_GT(green(0), 1000);  // the ball in the colour of the middle of its range
  EXPECT_LT(green(1), 50);    // switched off
  EXPECT_GT(ink(1), ink(2));  // the ring
  EXPECT_GT(ink(2), ink(3));  // the images
  EXPECT_GT(ink(3), ink(4));  // the mark
  EXPECT_GT(ink(4), 500);     // the cube with the patient's directions stays
  EXPECT_GT(green(5), 1000);  // the ball again, from above
  EXPECT_EQ(result["bars"], 1);
}

}  // namespace
}  // namespace isostack
