#include "viewers/scene_actors.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>

#include "viewers/palette.h"
#include "viewers/scene_points.h"

namespace isostack {

namespace {

vtkNew<vtkPolyData> polydata_of(const TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices_mm.size()));
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), mesh.vertices_mm[i].data());
  vtkNew<vtkCellArray> triangles;
  for (const Eigen::Vector3i& corners : mesh.triangles)
    triangles->InsertNextCell({corners.x(), corners.y(), corners.z()});
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetPolys(triangles);
  if (mesh.normals.size() == mesh.vertices_mm.size()) {
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(points->GetNumberOfPoints());
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
      normals->SetTuple(static_cast<vtkIdType>(i), mesh.normals[i].data());
    polydata->GetPointData()->SetNormals(normals);
  }
  return polydata;
}

void set_colour(const Eigen::Vector3d& rgb, vtkProperty& look) { look.SetColor(rgb.x(), rgb.y(), rgb.z()); }

/// The closed curves as polylines; coinciding neighbours are left out, as a line has no direction between them.
vtkNew<vtkPolyData> polydata_of(const ContourStack& organ) {
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
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetLines(lines);
  return polydata;
}

vtkNew<vtkPolyData> textured_quad(const Slice& slice) {
  vtkNew<vtkPoints> points;
  for (const Eigen::Vector3d& corner : corners_of(slice)) points->InsertNextPoint(corner.data());
  vtkNew<vtkCellArray> quad;
  quad->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkFloatArray> texture_coordinates;
  texture_coordinates->SetNumberOfComponents(2);
  for (const auto& uv : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 1), Eigen::Vector2d(0, 1)})
    texture_coordinates->InsertNextTuple(uv.data());
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetPolys(quad);
  polydata->GetPointData()->SetTCoords(texture_coordinates);
  return polydata;
}

vtkNew<vtkImageData> grey_image(const Image<float>& pixels, const GreyWindow& window) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(pixels.cols()), static_cast<int>(pixels.rows()), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* grey = static_cast<unsigned char*>(image->GetScalarPointer());
  const float span = std::max(window.high - window.low, 1e-6F);
  for (Eigen::Index i = 0; i < pixels.size(); ++i) {
    const float value = (pixels.data()[i] - window.low) / span;
    grey[i] = static_cast<unsigned char>(std::isfinite(value) ? std::clamp(value, 0.F, 1.F) * 255.F : 0.F);
  }
  return image;
}

}  // namespace

GreyWindow grey_window_of(const std::vector<Slice>& slices) {
  std::vector<float> values;
  for (const Slice& slice : slices)
    std::copy_if(slice.pixels.data(), slice.pixels.data() + slice.pixels.size(), std::back_inserter(values),
                 [](float value) { return std::isfinite(value); });
  if (values.empty()) return {};
  const auto percentile = [&](double fraction) {
    const auto rank = values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), rank, values.end());
    return *rank;
  };
  return {percentile(0.01), percentile(0.99)};
}

void add_surface(const TriangleMesh& mesh, std::size_t organ_index, double opacity, vtkRenderer& renderer) {
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkPolyData> polydata = polydata_of(mesh);
  if (polydata->GetPointData()->GetNormals()) {
    mapper->SetInputData(polydata);
  } else {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(polydata);
    normals->SplittingOn();
    normals->SetFeatureAngle(60);  // a cube's edges stay sharp, a scan's noise does not show
    normals->ConsistencyOff();
    mapper->SetInputConnection(normals->GetOutputPort());
  }
  // Contours lie on the surface: push it back by a hair so that they are not drawn in dashes.
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty& look = *actor->GetProperty();
  set_colour(organ_colours(organ_index).surface, look);
  look.SetOpacity(opacity);
  look.SetInterpolationToPhong();
  look.SetAmbient(0.12);
  look.SetDiffuse(0.88);
  look.SetSpecular(0.18);
  look.SetSpecularPower(30);
  renderer.AddActor(actor);
}

void add_contours(const ContourStack& organ, std::size_t organ_index, double width_pixels, vtkRenderer& renderer) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(polydata_of(organ));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty& look = *actor->GetProperty();
  set_colour(organ_colours(organ_index).contour, look);
  look.SetLineWidth(static_cast<float>(width_pixels));
  look.RenderLinesAsTubesOn();
  look.SetAmbient(0.6);  // thin lines: their colour matters more than their shading
  look.SetDiffuse(0.4);
  renderer.AddActor(actor);
}

void add_slice(const Slice& slice, const GreyWindow& window, vtkRenderer& renderer) {
  vtkNew<vtkTexture> texture;
  texture->SetInputData(grey_image(slice.pixels, window));
  texture->InterpolateOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(textured_quad(slice));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  actor->GetProperty()->LightingOff();
  renderer.AddActor(actor);
}

}  // namespace isostack
