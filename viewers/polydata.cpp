#include "viewers/polydata.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

#include <vector>

namespace isostack {

namespace {

vtkNew<vtkFloatArray> vectors(const std::vector<Eigen::Vector3d>& from) {
  vtkNew<vtkFloatArray> to;
  to->SetNumberOfComponents(3);
  to->SetNumberOfTuples(static_cast<vtkIdType>(from.size()));
  float* out = to->GetPointer(0);
  for (const Eigen::Vector3d& vector : from)
    for (const double coordinate : vector) *out++ = static_cast<float>(coordinate);
  return to;
}

}  // namespace

vtkSmartPointer<vtkPolyData> polydata_of(const TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetData(vectors(mesh.vertices_mm));
  vtkNew<vtkTypeInt32Array> corners;
  corners->SetNumberOfValues(3 * static_cast<vtkIdType>(mesh.triangles.size()));
  int* out = corners->GetPointer(0);
  for (const Eigen::Vector3i& triangle : mesh.triangles)
    for (const int corner : triangle) *out++ = corner;
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(3, corners);
  auto polydata = vtkSmartPointer<vtkPolyData>::New();
  polydata->SetPoints(points);
  polydata->SetPolys(triangles);
  if (mesh.normals.size() == mesh.vertices_mm.size()) polydata->GetPointData()->SetNormals(vectors(mesh.normals));
  return polydata;
}

vtkSmartPointer<vtkPolyData> polydata_of(const ContourStack& organ) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  std::vector<vtkIdType> ids;
  for (const ContourSlice& slice : organ.slices)
    for (const Contour& contour : slice.contours) {
      ids.clear();
      for (std::size_t i = 0; i < contour.points_mm.size(); ++i) {
        if (i > 0 && contour.points_mm[i] == contour.points_mm[i - 1]) continue;
        ids.push_back(points->InsertNextPoint(slice.pose.slice_to_world(contour.points_mm[i]).eval().data()));
      }
      if (ids.size() < 2) continue;
      ids.push_back(ids.front());
      lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
  auto polydata = vtkSmartPointer<vtkPolyData>::New();
  polydata->SetPoints(points);
  polydata->SetLines(lines);
  return polydata;
}

}  // namespace isostack
