#include "python/bindings.h"
#include "python/casters.h"
#include "viewers/page/page.h"
#include "viewers/scene.h"
#include "viewers/scene_title.h"
#include "viewers/scene_warnings.h"
#include "viewers/screenshot.h"

namespace isostack::python {

namespace py = pybind11;

namespace {

Scene make_scene(std::vector<TriangleMesh> surfaces, std::vector<ContourStack> contours, std::vector<Slice> slices,
                 const std::string& title, double opacity) {
  Scene scene{.title = title,
              .surfaces = scene_surfaces(std::move(surfaces)),
              .contours = scene_contours(std::move(contours)),
              .slices = scene_slices(std::move(slices))};
  for (SceneSurface& surface : scene.surfaces) surface.opacity = opacity;
  return scene;
}

}  // namespace

void bind_scene(py::module_& core) {
  const py::call_guard<py::gil_scoped_release> unlocked;
  py::class_<Scene> scene(core, "Scene",
                          "What there is to look at, all in world LPS mm. In a notebook it shows itself.");
  scene.def(py::init(&make_scene), py::arg("surfaces") = std::vector<TriangleMesh>(),
            py::arg("contours") = std::vector<ContourStack>(), py::arg("slices") = std::vector<Slice>(),
            py::arg("title") = "", py::arg("opacity") = 1.0,
            "Meshes, contour stacks and slices, copied; opacity: of the surfaces, 0 to 1.");
  scene.def_readwrite("title", &Scene::title, "names and key numbers; nothing of the patient");
  scene.def_property_readonly("warnings", &scene_warnings, "what makes the scene look wrong, a sentence each");
  scene.def("__repr__", [](const Scene& self) {
    return "<Scene, " + std::to_string(self.surfaces.size()) + " surfaces, " + std::to_string(self.contours.size()) +
           " organs' contours, " + std::to_string(self.slices.size()) + " slices>";
  });
  core.def(
      "page_html",
      [](const Scene& of, bool dark, const Eigen::Vector3d& view_from, std::size_t most_triangles) {
        return page_html(of, {.dark = dark, .view_from = view_from, .most_triangles = most_triangles});
      },
      py::arg("scene"), py::arg("dark") = false, py::arg("view_from") = PageOptions().view_from,
      py::arg("most_triangles") = PageOptions().most_triangles, unlocked,
      "One HTML page that shows the scene in any browser with WebGL, without asking the network for anything. "
      "view_from: direction from the scene to the camera, LPS.");
  core.def(
      "save_page",
      [](const Scene& of, const std::filesystem::path& path, bool dark, const Eigen::Vector3d& view_from) {
        save_page(of, path, {.dark = dark, .view_from = view_from});
      },
      py::arg("scene"), py::arg("path"), py::arg("dark") = false, py::arg("view_from") = PageOptions().view_from,
      unlocked, "The same as a file.");
  core.def(
      "save_screenshot",
      [](const Scene& of, const std::filesystem::path& path, int width_pixels, int height_pixels,
         const Eigen::Vector3d& view_from) {
        save_screenshot(
            of, path, {.width_pixels = width_pixels, .height_pixels = height_pixels, .look = {.view_from = view_from}});
      },
      py::arg("scene"), py::arg("path"), py::arg("width_pixels") = 1200, py::arg("height_pixels") = 900,
      py::arg("view_from") = PageOptions().view_from, unlocked,
      "A picture of the scene as PNG. Needs a display (or xvfb-run).");
}

}  // namespace isostack::python
