#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <iterator>

#include "io/atomic_file.h"
#include "io/meshes/mesh_building.h"
#include "io/meshes/mesh_vtk.h"
#include "io/vtk_errors.h"
#include "io/vtp_file.h"

namespace isostack {

namespace {

/// The name as field data, the colour as that of every point, which viewers show without being told.
void add_looks(const TriangleMesh& mesh, vtkPolyData& data) {
  if (!mesh.name.empty()) {
    vtkNew<vtkStringArray> name;
    name->SetName("name");
    name->InsertNextValue(mesh.name);
    data.GetFieldData()->AddArray(name);
  }
  if (!mesh.color) return;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
    colors->InsertNextTuple3(mesh.color->red, mesh.color->green, mesh.color->blue);
  data.GetPointData()->SetScalars(colors);
}

vtkSmartPointer<vtkPolyData> to_vtk(const TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& vertex : mesh.vertices_mm) points->InsertNextPoint(vertex.data());
  vtkNew<vtkCellArray> cells;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const vtkIdType corners[3] = {triangle[0], triangle[1], triangle[2]};
    cells->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  if (!mesh.normals.empty()) {
    vtkNew<vtkDoubleArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (const Eigen::Vector3d& normal : mesh.normals) normals->InsertNextTuple(normal.data());
    data->GetPointData()->SetNormals(normals);
  }
  add_looks(mesh, *data);
  return data;
}

}  // namespace

void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path) {
  AtomicFile file(path);
  const vtkNew<vtkSTLWriter> writer;
  const vtkNew<VtkErrors> errors = capture_errors(*writer);
  writer->SetFileTypeToBinary();
  writer->SetFileName(file.temporary().c_str());
  writer->SetInputData(to_vtk(mesh));
  if (writer->Write() == 0 || errors->any() || writer->GetErrorCode() != 0)
    throw InputError(path.string(), "it cannot be written to the end", "check that the disk has free space");
  file.commit();
}

/// VTK's writer keeps six digits only, a hundredth of a millimetre at a metre. Colours stand behind the coordinates,
/// where most programs look for them without a second file of materials.
void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path) {
  std::string text = "# LPS mm\n";
  const auto out = std::back_inserter(text);
  if (!mesh.name.empty()) fmt::format_to(out, "o {}\n", one_line(mesh.name));
  const Color c = mesh.color.value_or(Color{});
  const std::string color =
      mesh.color ? fmt::format(" {:.4f} {:.4f} {:.4f}", c.red / 255.0, c.green / 255.0, c.blue / 255.0) : "";
  for (const Eigen::Vector3d& v : mesh.vertices_mm)
    fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}{}\n", v.x(), v.y(), v.z(), color);
  for (const Eigen::Vector3d& n : mesh.normals) fmt::format_to(out, "vn {:.6g} {:.6g} {:.6g}\n", n.x(), n.y(), n.z());
  const char* const face = mesh.normals.empty() ? "f {0} {1} {2}\n" : "f {0}//{0} {1}//{1} {2}//{2}\n";
  for (const Eigen::Vector3i& t : mesh.triangles) fmt::format_to(out, fmt::runtime(face), t[0] + 1, t[1] + 1, t[2] + 1);
  write_whole_file(path, text);
}

void write_vtp_mesh(const TriangleMesh& mesh, const std::filesystem::path& path) { write_vtp(*to_vtk(mesh), path); }

}  // namespace isostack
