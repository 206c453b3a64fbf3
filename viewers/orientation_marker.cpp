#include "viewers/orientation_marker.h"

#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace isostack {

namespace {

vtkNew<vtkAnnotatedCubeActor> patient_cube(bool dark) {
  vtkNew<vtkAnnotatedCubeActor> cube;
  // World is LPS: growing x is left, growing y posterior, growing z superior.
  cube->SetXPlusFaceText("L");
  cube->SetXMinusFaceText("R");
  cube->SetYPlusFaceText("P");
  cube->SetYMinusFaceText("A");
  cube->SetZPlusFaceText("S");
  cube->SetZMinusFaceText("I");
  // VTK writes the letters for y up; these turns make them upright with superior up.
  cube->SetXFaceTextRotation(0);
  cube->SetYFaceTextRotation(0);
  cube->SetZFaceTextRotation(90);
  cube->SetFaceTextScale(0.62);
  const double face = dark ? 0.35 : 0.95, letter = dark ? 0.92 : 0.20;
  cube->GetCubeProperty()->SetColor(face, face, face);
  cube->GetCubeProperty()->SetAmbient(0.45);
  cube->GetCubeProperty()->SetDiffuse(0.55);
  cube->SetTextEdgesVisibility(0);
  for (vtkProperty* text : {cube->GetXPlusFaceProperty(), cube->GetXMinusFaceProperty(), cube->GetYPlusFaceProperty(),
                            cube->GetYMinusFaceProperty(), cube->GetZPlusFaceProperty(), cube->GetZMinusFaceProperty()})
    text->SetColor(letter, letter, letter);
  return cube;
}

/// Turns the marker's camera to look as the scene's does, just before the scene is drawn.
class FollowCamera : public vtkCommand {
 public:
  static FollowCamera* New() { return new FollowCamera; }
  vtkSmartPointer<vtkRenderer> marker;

  void Execute(vtkObject* caller, unsigned long, void*) override {
    vtkCamera& followed = *static_cast<vtkRenderer*>(caller)->GetActiveCamera();
    vtkCamera& camera = *marker->GetActiveCamera();
    const double* towards_scene = followed.GetDirectionOfProjection();
    camera.SetFocalPoint(0, 0, 0);
    camera.SetPosition(-5 * towards_scene[0], -5 * towards_scene[1], -5 * towards_scene[2]);
    camera.SetViewUp(followed.GetViewUp());
    camera.ParallelProjectionOn();
    camera.SetParallelScale(0.95);
    marker->ResetCameraClippingRange();
  }
};

}  // namespace

void add_orientation_marker(bool dark, vtkRenderer& renderer, vtkRenderWindow& window) {
  constexpr double height_share = 0.15;
  const int* size = renderer.GetSize();
  const double width_share = height_share * size[1] / size[0];
  const double* part = renderer.GetViewport();
  const double across = part[2] - part[0], up = part[3] - part[1];
  vtkNew<vtkRenderer> marker;
  marker->SetViewport(part[0] + 0.01 * across, part[1] + 0.01 * up, part[0] + (0.01 + width_share) * across,
                      part[1] + (0.01 + height_share) * up);
  marker->AddActor(patient_cube(dark));
  marker->SetLayer(1);
  marker->InteractiveOff();
  window.SetNumberOfLayers(2);
  window.AddRenderer(marker);

  vtkNew<FollowCamera> follow;
  follow->marker = marker;
  renderer.AddObserver(vtkCommand::StartEvent, follow);
}

}  // namespace isostack
