#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkStringArray.h>

#include <cstring>
#include <fstream>

#include "io/meshes/mesh_building.h"
#include "io/meshes/mesh_vtk.h"
#include "io/volumes/text_header.h"
#include "io/vtk_errors.h"
#include "io/vtp_file.h"

namespace isostack {

namespace {

void add_points(vtkPolyData& data, TriangleMesh& mesh) {
  const auto count = static_cast<std::size_t>(data.GetNumberOfPoints());
  mesh.vertices_mm.resize(count);
  for (std::size_t i = 0; i < count; ++i) data.GetPoint(static_cast<vtkIdType>(i), mesh.vertices_mm[i].data());
  vtkDataArray* normals = data.GetPointData()->GetNormals();
  if (!normals || normals->GetNumberOfComponents() != 3 || normals->GetNumberOfTuples() != data.GetNumberOfPoints())
    return;
  mesh.normals.resize(count);
  for (std::size_t i = 0; i < count; ++i) normals->GetTuple(static_cast<vtkIdType>(i), mesh.normals[i].data());
}

TriangleMesh mesh_from(vtkPolyData& data, const std::filesystem::path& path) {
  TriangleMesh mesh;
  add_points(data, mesh);
  const auto cell = vtk::TakeSmartPointer(data.GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(count, corners);
    add_polygon({corners, static_cast<std::size_t>(count)}, mesh, path.string());
  }
  complete_mesh(mesh, path.string());
  return mesh;
}

/// VTK takes a binary file that is cut off as a smaller mesh: it must be as long as its number of
/// triangles says. A text file must have its last word.
void require_whole_stl(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  constexpr std::size_t header_bytes = 84, triangle_bytes = 50;
  std::uint32_t triangles = 0;
  if (bytes.size() >= header_bytes) std::memcpy(&triangles, bytes.data() + 80, sizeof(triangles));
  const bool whole_binary = bytes.size() >= header_bytes + triangle_bytes * std::size_t{triangles} && triangles > 0;
  const bool whole_text = bytes.starts_with("solid") && bytes.find("endsolid") != std::string::npos;
  if (!whole_binary && !whole_text)
    throw InputError(path.string(), "it is not a whole STL file", "it is empty, truncated or another format");
}

/// Name and colours, which VTK's reader skips. Several objects in one file have no common name.
void read_obj_looks(const std::filesystem::path& path, TriangleMesh& mesh) {
  std::ifstream stream(path);
  CommonColor color;
  int objects = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.starts_with("o ") && ++objects == 1) mesh.name = line.substr(2);
    if (!line.starts_with("v ")) continue;
    const std::vector<double> numbers = parse_numbers(line.substr(2));
    color.add(numbers.size() == 6 ? Eigen::Vector3d(Eigen::Vector3d::Map(numbers.data() + 3) * 255)
                                  : Eigen::Vector3d::Constant(-1));
  }
  if (objects > 1) mesh.name.clear();
  mesh.color = color.color();
}

}  // namespace

TriangleMesh read_stl(const std::filesystem::path& path) {
  require_whole_stl(path);
  const vtkNew<vtkSTLReader> reader;
  reader->MergingOff();
  reader->SetFileName(path.c_str());
  update_or_throw(*reader, path);
  TriangleMesh mesh = mesh_from(*reader->GetOutput(), path);
  merge_coinciding(mesh);
  return mesh;
}

TriangleMesh read_obj(const std::filesystem::path& path) {
  const vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path.c_str());
  update_or_throw(*reader, path);
  TriangleMesh mesh = mesh_from(*reader->GetOutput(), path);
  merge_coinciding(mesh);
  read_obj_looks(path, mesh);
  return mesh;
}

TriangleMesh read_vtp_mesh(const std::filesystem::path& path) {
  const vtkSmartPointer<vtkPolyData> data = read_vtp(path);
  TriangleMesh mesh = mesh_from(*data, path);
  auto* name = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("name"));
  if (name && name->GetNumberOfValues() == 1) mesh.name = name->GetValue(0);
  vtkDataArray* colors = data->GetPointData()->GetArray("color");
  if (!colors || colors->GetDataType() != VTK_UNSIGNED_CHAR || colors->GetNumberOfComponents() != 3) return mesh;
  CommonColor color;
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i) color.add(Eigen::Vector3d(colors->GetTuple3(i)));
  mesh.color = color.color();
  return mesh;
}

}  // namespace isostack
