#include "viewers/axes_box.h"

#include <vtkCubeAxesActor.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

namespace isostack {

void add_axes_box(const Eigen::AlignedBox3d& box_mm, const Eigen::Vector3d& ink, vtkRenderer& renderer) {
  vtkNew<vtkCubeAxesActor> axes;
  axes->SetBounds(box_mm.min().x(), box_mm.max().x(), box_mm.min().y(), box_mm.max().y(), box_mm.min().z(),
                  box_mm.max().z());
  axes->SetCamera(renderer.GetActiveCamera());
  axes->SetFlyModeToOuterEdges();
  axes->SetXTitle("L");
  axes->SetYTitle("P");
  axes->SetZTitle("S");
  axes->SetXUnits("mm");
  axes->SetYUnits("mm");
  axes->SetZUnits("mm");
  axes->SetXLabelFormat("%.0f");
  axes->SetYLabelFormat("%.0f");
  axes->SetZLabelFormat("%.0f");
  axes->SetScreenSize(13);
  for (int axis = 0; axis < 3; ++axis) {
    axes->GetTitleTextProperty(axis)->SetColor(ink.x(), ink.y(), ink.z());
    axes->GetLabelTextProperty(axis)->SetColor(ink.x(), ink.y(), ink.z());
  }
  for (vtkProperty* lines :
       {axes->GetXAxesLinesProperty(), axes->GetYAxesLinesProperty(), axes->GetZAxesLinesProperty()})
    lines->SetColor(ink.x(), ink.y(), ink.z());
  renderer.AddActor(axes);
}

}  // namespace isostack
