#include "viewers/window/overlay.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "viewers/polydata.h"

namespace isostack {

namespace {

vtkSmartPointer<vtkActor> unlit_actor(vtkPolyData* polydata, const Eigen::Vector3d& colour) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(polydata);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -4);  // in front of the image and surface they lie on
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-8);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
  actor->PickableOff();
  return actor;
}

}  // namespace

vtkSmartPointer<vtkActor> curves_actor(const SlicePose& pose, const std::vector<Contour>& contours,
                                       const Eigen::Vector3d& colour, double width_pixels) {
  ContourStack stack;
  stack.slices.push_back({.name = {}, .pose = pose, .contours = contours});
  auto actor = unlit_actor(polydata_of(stack), colour);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width_pixels));
  return actor;
}

vtkSmartPointer<vtkActor> dots_actor(const std::vector<Eigen::Vector3d>& points_mm, const Eigen::Vector3d& colour,
                                     double size_pixels) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> dots;
  for (const Eigen::Vector3d& point : points_mm) dots->InsertNextCell({points->InsertNextPoint(point.data())});
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetVerts(dots);
  auto actor = unlit_actor(polydata, colour);
  actor->GetProperty()->SetPointSize(static_cast<float>(size_pixels));
  actor->GetProperty()->RenderPointsAsSpheresOn();
  return actor;
}

void Overlay::clear() {
  for (const auto& actor : actors_) renderer_.RemoveViewProp(actor);
  actors_.clear();
}

void Overlay::add(const vtkSmartPointer<vtkProp>& actor) {
  renderer_.AddViewProp(actor);
  actors_.push_back(actor);
}

}  // namespace isostack
