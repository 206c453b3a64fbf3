#include "viewers/mark_actors.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>

namespace isostack {

namespace {

// Told apart from contours and surfaces on light and dark grounds, and on grey images.
constexpr double line_rgb[3] = {0.95, 0.10, 0.55};

vtkSmartPointer<vtkProp> lines_of(const std::vector<SceneMark>& marks, double height_pixels) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines, ends;
  for (const SceneMark& mark : marks) {
    if (!mark.visible) continue;
    const vtkIdType from = points->InsertNextPoint(mark.from_mm.data());
    const vtkIdType to = points->InsertNextPoint(mark.to_mm.data());
    lines->InsertNextCell({from, to});
    ends->InsertNextCell({from});
    ends->InsertNextCell({to});
  }
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetLines(lines);
  polydata->SetVerts(ends);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(polydata);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty& look = *actor->GetProperty();
  look.SetColor(line_rgb[0], line_rgb[1], line_rgb[2]);
  look.SetLineWidth(static_cast<float>(0.006 * height_pixels));
  look.SetPointSize(static_cast<float>(0.011 * height_pixels));
  look.RenderPointsAsSpheresOn();
  look.LightingOff();
  return actor;
}

vtkSmartPointer<vtkProp> text_of(const SceneMark& mark, double height_pixels) {
  auto text = vtkSmartPointer<vtkBillboardTextActor3D>::New();
  text->SetInput(mark.text.c_str());
  Eigen::Vector3d middle_mm = (mark.from_mm + mark.to_mm) / 2;
  text->SetPosition(middle_mm.data());
  text->SetDisplayOffset(static_cast<int>(0.012 * height_pixels), static_cast<int>(0.012 * height_pixels));
  text->ForceOpaqueOn();
  vtkTextProperty& look = *text->GetTextProperty();
  look.SetFontFamilyToArial();
  look.SetFontSize(static_cast<int>(0.026 * height_pixels));
  look.SetColor(1, 1, 1);
  look.SetBackgroundColor(line_rgb[0] * 0.75, line_rgb[1] * 0.75, line_rgb[2] * 0.75);
  look.SetBackgroundOpacity(1);
  look.SetBold(true);
  return text;
}

}  // namespace

std::vector<vtkSmartPointer<vtkProp>> mark_actors(const std::vector<SceneMark>& marks, double height_pixels) {
  std::vector<vtkSmartPointer<vtkProp>> actors;
  if (marks.empty()) return actors;
  actors.push_back(lines_of(marks, height_pixels));
  for (const SceneMark& mark : marks)
    if (mark.visible && !mark.text.empty()) actors.push_back(text_of(mark, height_pixels));
  return actors;
}

}  // namespace isostack
