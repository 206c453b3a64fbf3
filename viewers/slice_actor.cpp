#include "viewers/slice_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <algorithm>

#include "viewers/scene_points.h"

namespace isostack {

namespace {

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

vtkNew<vtkTexture> texture_of(const Image<float>& pixels, const GreyWindow& window) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(pixels.cols()), static_cast<int>(pixels.rows()), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const Image<std::uint8_t> grey = grey_levels(pixels, window);
  std::copy_n(grey.data(), grey.size(), static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

}  // namespace

SliceActor::SliceActor() : actor_(vtkSmartPointer<vtkActor>::New()) { actor_->GetProperty()->LightingOff(); }

void SliceActor::rebuild(const SceneSlice& item, const GreyWindow& grey) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(textured_quad(item.image));
  // Contours lie in the plane: push it back by a hair so that they are not drawn in dashes.
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2);
  actor_->SetMapper(mapper);
  actor_->SetTexture(nullptr);
  update_look(item, grey);
}

void SliceActor::update_look(const SceneSlice& item, const GreyWindow& grey) {
  const bool visible = item.visible && item.image.pixels.size() > 0;
  actor_->SetVisibility(visible);
  actor_->GetProperty()->SetOpacity(item.opacity);
  if (!visible) {
    actor_->SetTexture(nullptr);
  } else if (!actor_->GetTexture() || !(shown_ == grey)) {
    actor_->SetTexture(texture_of(item.image.pixels, grey));
    shown_ = grey;
  }
}

}  // namespace isostack
