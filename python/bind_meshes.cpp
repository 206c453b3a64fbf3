#include "python/arrays.h"
#include "python/bindings.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack::python {

namespace {

void require_corners(const TriangleMesh& mesh) {
  const auto count = static_cast<int>(mesh.vertices_mm.size());
  for (const Eigen::Vector3i& triangle : mesh.triangles)
    if (triangle.minCoeff() < 0 || triangle.maxCoeff() >= count)
      throw InputError("triangles", "a corner is not among the " + std::to_string(count) + " vertices",
                       "number the vertices from 0");
}

TriangleMesh make_mesh(const py::object& vertices_mm, const py::object& triangles, const py::object& normals,
                       const std::string& name, const std::optional<Color>& color) {
  TriangleMesh mesh{.name = name,
                    .vertices_mm = rows_from<double, 3>(vertices_mm, "vertices_mm"),
                    .triangles = rows_from<int, 3>(triangles, "triangles"),
                    .normals = {},
                    .color = color};
  if (!normals.is_none()) mesh.normals = rows_from<double, 3>(normals, "normals");
  if (!mesh.normals.empty() && mesh.normals.size() != mesh.vertices_mm.size())
    throw InputError("normals",
                     std::to_string(mesh.normals.size()) + " normals do not fit to " +
                         std::to_string(mesh.vertices_mm.size()) + " vertices",
                     "give one per vertex, or None");
  require_corners(mesh);
  return mesh;
}

/// An array attribute: a view that may be written, not replaced by one of another size.
template <class Rows>
void add_rows(py::class_<TriangleMesh>& mesh, const char* name, Rows TriangleMesh::*rows, const char* about) {
  const auto view = [rows](const py::object& self) { return rows_view(self.cast<TriangleMesh&>().*rows, self); };
  mesh.def_property(
      name, view,
      [view, name](const py::object& self, const py::object& values) { assign_in_place(view(self), values, name); },
      about);
}

}  // namespace

void bind_meshes(py::module_& core) {
  py::class_<TriangleMesh> mesh(core, "TriangleMesh",
                                "Indexed triangles in world LPS mm; corners run counter-clockwise seen from outside. "
                                "In a notebook it shows itself.");
  mesh.def(py::init(&make_mesh), py::arg("vertices_mm"), py::arg("triangles"), py::arg("normals") = py::none(),
           py::arg("name") = "", py::arg("color") = py::none(),
           "vertices_mm: (N, 3) real numbers, LPS mm; triangles: (M, 3) whole numbers, vertices counted from 0; "
           "normals: (N, 3) unit vectors outwards, or None. All are copied.");
  add_rows(mesh, "vertices_mm", &TriangleMesh::vertices_mm, "(N, 3) float64, world LPS mm, a view");
  add_rows(mesh, "triangles", &TriangleMesh::triangles, "(M, 3) int32, vertices counted from 0, a view");
  add_rows(mesh, "normals", &TriangleMesh::normals, "(N, 3) float64, unit vectors outwards, a view; (0, 3): none");
  mesh.def_readwrite("name", &TriangleMesh::name, "of the organ");
  mesh.def_readwrite("color", &TriangleMesh::color, "(red, green, blue), 0 to 255, or None");
  mesh.def(py::pickle(
      [](const py::object& self) {
        return py::make_tuple(self.attr("vertices_mm"), self.attr("triangles"), self.attr("normals"), self.attr("name"),
                              self.attr("color"));
      },
      [](const py::tuple& parts) {
        return make_mesh(parts[0], parts[1], parts[2], parts[3].cast<std::string>(),
                         parts[4].cast<std::optional<Color>>());
      }));
  mesh.def("__copy__", [](const TriangleMesh& self) { return TriangleMesh(self); });
  mesh.def(
      "__deepcopy__", [](const TriangleMesh& self, const py::dict&) { return TriangleMesh(self); }, py::arg("memo"));
  mesh.def("__repr__", [](const TriangleMesh& self) {
    return "<TriangleMesh '" + self.name + "', " + std::to_string(self.vertices_mm.size()) + " vertices, " +
           std::to_string(self.triangles.size()) + " triangles>";
  });
}

}  // namespace isostack::python
