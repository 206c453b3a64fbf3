#include "sample_data/phantom_surface.h"

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "sample_data/phantom.h"

namespace isostack {

namespace {

vtkNew<vtkImageData> sampled_phantom(double lattice_mm) {
  const Eigen::AlignedBox3d box = phantom_bounds_mm();
  const Eigen::Vector3i size = (box.sizes() / lattice_mm).array().ceil().cast<int>() + 1;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size.data());
  image->SetOrigin(box.min().data());
  image->SetSpacing(lattice_mm, lattice_mm, lattice_mm);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image->GetScalarPointer());
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i)
        *value++ = static_cast<float>(phantom_distance_mm(box.min() + lattice_mm * Eigen::Vector3d(i, j, k)));
  return image;
}

}  // namespace

TriangleMesh phantom_surface(double lattice_mm) {
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(sampled_phantom(lattice_mm));
  edges->SetValue(0, 0);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  vtkPolyData& polydata = *edges->GetOutput();

  TriangleMesh mesh{.name = "phantom", .vertices_mm = {}, .triangles = {}, .normals = {}};
  mesh.vertices_mm.resize(static_cast<std::size_t>(polydata.GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
    polydata.GetPoint(static_cast<vtkIdType>(i), mesh.vertices_mm[i].data());
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < polydata.GetNumberOfCells(); ++i) {
    polydata.GetCellPoints(i, corners);
    mesh.triangles.emplace_back(static_cast<int>(corners->GetId(0)), static_cast<int>(corners->GetId(1)),
                                static_cast<int>(corners->GetId(2)));
  }
  return mesh;
}

}  // namespace isostack
