// draw_scene [TRIANGLES] [SLICES] [PIXELS]: how long a scene of one surface and some slices takes to open, and each
// frame of a turn at 1000x800, as windows draw it. Run it under xvfb-run.
#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <vector>

#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"
#include "viewers/scene_view.h"

namespace {

using namespace isostack;

/// A ball of 80 mm with bumps, and normals.
TriangleMesh bumpy_ball(int triangles) {
  const int meridians = static_cast<int>(std::sqrt(triangles)), parallels = meridians / 2;
  TriangleMesh mesh;
  for (int j = 0; j <= parallels; ++j)
    for (int i = 0; i < meridians; ++i) {
      const double u = 2 * std::numbers::pi * i / meridians, v = std::numbers::pi * j / parallels;
      const Eigen::Vector3d out(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v));
      mesh.vertices_mm.push_back((80 + 2 * std::sin(12 * u) * std::sin(12 * v)) * out);
      mesh.normals.push_back(out);
    }
  for (int j = 0; j < parallels; ++j)
    for (int i = 0; i < meridians; ++i) {
      const int a = j * meridians + i, b = j * meridians + (i + 1) % meridians;
      mesh.triangles.emplace_back(a, a + meridians, b);
      mesh.triangles.emplace_back(b, a + meridians, b + meridians);
    }
  return mesh;
}

Slice slice_at(double z_mm, int pixels) {
  Slice slice{.name = "", .pose = {}, .pixels = Image<float>(pixels, pixels)};
  slice.pose.spacing_mm.setConstant(200.0 / pixels);
  slice.pose.origin_mm = {-100, -100, z_mm};
  for (Eigen::Index i = 0; i < slice.pixels.size(); ++i) slice.pixels.data()[i] = static_cast<float>(i % 1000);
  return slice;
}

/// Median of frames of a turn; reading a pixel waits for the drawing to end. Also tells the processor time of a frame,
/// over all threads, which other programs on the machine change little.
double frame_seconds(SceneView& view, vtkRenderWindow& window) {
  constexpr int frames = 12;
  const std::clock_t start = std::clock();
  std::vector<double> seconds;
  for (int i = 0; i < frames; ++i) {
    const Stopwatch watch;
    view.aim(Eigen::AngleAxisd(0.2 * i, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(0.5, -0.9, 0.35));
    window.Render();
    delete[] window.GetPixelData(0, 0, 0, 0, 0);
    seconds.push_back(watch.seconds());
  }
  fmt::print("processor time of a frame: {:.0f} ms\n",
             1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / frames);
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int triangles = argc > 1 ? std::atoi(argv[1]) : 500'000;
  const int slices = argc > 2 ? std::atoi(argv[2]) : 0;
  const int pixels = argc > 3 ? std::atoi(argv[3]) : 512;
  Scene scene;
  scene.surfaces.push_back({.mesh = bumpy_ball(triangles)});
  for (int k = 0; k < slices; ++k)
    scene.slices.push_back({.image = slice_at(-90 + 180.0 * k / slices, pixels), .visible = k == slices / 2});
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(1000, 800);

  const Stopwatch opening;
  SceneView view(scene, {.quality = Quality::fast}, *window);
  window->Render();
  delete[] window->GetPixelData(0, 0, 0, 0, 0);
  const double opening_s = opening.seconds();
  const double still_s = frame_seconds(view, *window);
  const Stopwatch proxy;
  view.set_moving(true);
  const double proxy_s = proxy.seconds();
  const double moving_s = frame_seconds(view, *window);
  view.set_moving(false);
  scene.surfaces[0].opacity = 0.5;
  view.update_looks();
  const double clear_s = frame_seconds(view, *window);
  scene.surfaces[0].opacity = 1;
  double scroll_s = 0;
  if (slices > 1) {
    const Stopwatch scrolling;
    for (int k = 1; k <= 10; ++k) {
      scene.slices[static_cast<std::size_t>((slices / 2 + k - 1) % slices)].visible = false;
      scene.slices[static_cast<std::size_t>((slices / 2 + k) % slices)].visible = true;
      view.update_looks();
      window->Render();
      delete[] window->GetPixelData(0, 0, 0, 0, 0);
    }
    scroll_s = scrolling.seconds() / 10;
  }
  fmt::print(
      "{} triangles, {} slices of {}^2, 1000x800: opens in {:.2f} s, frame {:.0f} ms, see-through {:.0f} ms, moving "
      "{:.0f} ms (made in {:.2f} s), next slice {:.0f} ms, {:.0f} MB\n",
      scene.surfaces[0].mesh.triangles.size(), slices, pixels, opening_s, 1e3 * still_s, 1e3 * clear_s, 1e3 * moving_s,
      proxy_s, 1e3 * scroll_s, static_cast<double>(peak_memory_bytes()) / 1e6);
}
