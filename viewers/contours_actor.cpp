#include "viewers/contours_actor.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include "viewers/palette.h"
#include "viewers/polydata.h"

namespace isostack {

void rebuild_contours(const SceneContours& item, vtkActor& actor) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(polydata_of(item.stack));
  actor.SetMapper(mapper);
}

void update_contours_look(const SceneContours& item, std::size_t index, double width_pixels, vtkActor& actor) {
  vtkProperty& look = *actor.GetProperty();
  Eigen::Vector3d rgb = organ_colours(index).contour;
  if (item.stack.color)
    rgb = Eigen::Vector3d(item.stack.color->red, item.stack.color->green, item.stack.color->blue) / 255;
  look.SetColor(rgb.x(), rgb.y(), rgb.z());
  look.SetLineWidth(static_cast<float>(width_pixels));
  look.RenderLinesAsTubesOn();
  look.SetAmbient(0.6);  // thin lines: their colour matters more than their shading
  look.SetDiffuse(0.4);
  look.SetOpacity(item.opacity);
  actor.SetVisibility(item.visible);
}

}  // namespace isostack
