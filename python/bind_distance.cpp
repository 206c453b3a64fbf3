#include "io/solid_file.h"
#include "python/bindings.h"
#include "python/progress.h"
#include "python/struct_class.h"
#include "recon/distance/distance_surface.h"
#include "recon/distance/mended_mesh.h"
#include "recon/distance/mesh_distance.h"
#include "recon/distance/solid.h"

namespace isostack::python {

namespace {

void bind_options(py::module_& core) {
  py::enum_<DistanceExtent>(core, "DistanceExtent", "How far distances reach.")
      .value("band", DistanceExtent::band, "voxels beyond the band hold ± its width")
      .value("full", DistanceExtent::full, "everywhere");
  py::enum_<MeshSign>(core, "MeshSign", "What is inside a mesh.")
      .value("by_crossings", MeshSign::by_crossings, "what rows enter an odd number of times")
      .value("by_winding", MeshSign::by_winding, "where the winding number is beyond 1/2: overlaps unite");
  using M = MeshDistanceOptions;
  StructClass<M>(core, "MeshDistanceOptions", "How a mesh becomes distances.\n")
      .field("band_mm", &M::band_mm, "distances up to this are exact, mm; 0: three of the grid's longest voxel edges")
      .field("extent", &M::extent, "\"band\" or \"full\"")
      .field("sign", &M::sign, "\"by_crossings\" or \"by_winding\"")
      .done();
  using S = SolidDistanceOptions;
  StructClass<S>(core, "SolidDistanceOptions", "How a solid becomes distances.\n")
      .field("tolerance_mm", &S::tolerance_mm, "how far distances may be off, mm; 0: 2.5e-4 of the solid's diagonal")
      .field("band_mm", &S::band_mm, "as MeshDistanceOptions have it")
      .field("extent", &S::extent, "\"band\" or \"full\"")
      .done();
  StructClass<DistanceSurfaceOptions>(core, "DistanceSurfaceOptions", "How distances become a surface.\n")
      .field("resolution_mm", &DistanceSurfaceOptions::resolution_mm,
             "edge of the cells, mm; 0: the volume's shortest voxel edge")
      .done();
}

void bind_solid(py::module_& core) {
  py::class_<CsgSolid> solid(core, "CsgSolid", "A constructive solid, from a .json file. World LPS mm.");
  solid.def_readonly("name", &CsgSolid::name, "names the solid in messages");
  core.def("read_solid", &read_solid, py::arg("path"), py::call_guard<py::gil_scoped_release>(),
           "Reads a constructive solid (.json, docs/distance.md).");
  core.def(
      "solid_distance",
      [](const CsgSolid& of, const Grid& grid, const SolidDistanceOptions& options, const py::object& progress) {
        return without_lock(progress,
                            [&](const Progress& p) { return solid_distance(of, grid, options, p).distance_mm; });
      },
      py::arg("solid"), py::arg("grid"), py::arg("options") = SolidDistanceOptions(), py::arg("progress") = py::none());
}

}  // namespace

void bind_distance(py::module_& core) {
  bind_options(core);
  bind_solid(core);
  core.def("distance_grid", py::overload_cast<const TriangleMesh&, double, double>(&distance_grid), py::arg("body"),
           py::arg("spacing_mm"), py::arg("margin_mm"));
  core.def("distance_grid", py::overload_cast<const CsgSolid&, double, double>(&distance_grid), py::arg("body"),
           py::arg("spacing_mm"), py::arg("margin_mm"),
           "A grid along the world's axes with cubic voxels round a mesh or a solid, `margin_mm` wider on every side.");
  core.def(
      "mesh_distance",
      [](const TriangleMesh& mesh, const Grid& grid, const MeshDistanceOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) {
          MeshDistance found = mesh_distance(mesh, grid, options, p);
          return std::pair(std::move(found.distance_mm), std::move(found.remarks));
        });
      },
      py::arg("mesh"), py::arg("grid"), py::arg("options") = MeshDistanceOptions(), py::arg("progress") = py::none());
  core.def(
      "distance_surface",
      [](const Volume<float>& distances, const DistanceSurfaceOptions& options, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) { return distance_surface(distances, options, p); });
      },
      py::arg("distances"), py::arg("options") = DistanceSurfaceOptions(), py::arg("progress") = py::none());
  core.def(
      "mended_mesh",
      [](const TriangleMesh& mesh, const py::object& progress) {
        return without_lock(progress, [&](const Progress& p) {
          MendedMesh mended = mended_mesh(mesh, p);
          return std::pair(std::move(mended.mesh), std::move(mended.remarks));
        });
      },
      py::arg("mesh"), py::arg("progress") = py::none());
}

}  // namespace isostack::python
