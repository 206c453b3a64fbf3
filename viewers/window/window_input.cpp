#include "viewers/window/window_input.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

namespace isostack {

vtkStandardNewMacro(WindowStyle);

int WindowStyle::x() const { return Interactor->GetEventPosition()[0]; }
int WindowStyle::y() const { return Interactor->GetEventPosition()[1]; }

void WindowStyle::OnLeftButtonDown() {
  if (!input_->press(x(), y(), PointerButton::left)) Superclass::OnLeftButtonDown();
}

void WindowStyle::OnMiddleButtonDown() {
  if (!input_->press(x(), y(), PointerButton::middle)) Superclass::OnMiddleButtonDown();
}

void WindowStyle::OnRightButtonDown() {
  if (!input_->press(x(), y(), PointerButton::right)) Superclass::OnRightButtonDown();
}

void WindowStyle::OnLeftButtonUp() {
  if (!input_->release(x(), y())) Superclass::OnLeftButtonUp();
}

void WindowStyle::OnMiddleButtonUp() {
  if (!input_->release(x(), y())) Superclass::OnMiddleButtonUp();
}

void WindowStyle::OnRightButtonUp() {
  if (!input_->release(x(), y())) Superclass::OnRightButtonUp();
}

void WindowStyle::OnMouseMove() {
  if (input_->move(x(), y())) return;
  Superclass::OnMouseMove();
  if (State != VTKIS_NONE) input_->camera_moved();
}

bool WindowStyle::wheel(bool forward) { return input_->wheel(x(), y(), forward, Interactor->GetControlKey() != 0); }

void WindowStyle::OnMouseWheelForward() {
  if (wheel(true)) return;
  Superclass::OnMouseWheelForward();
  input_->camera_moved();
}

void WindowStyle::OnMouseWheelBackward() {
  if (wheel(false)) return;
  Superclass::OnMouseWheelBackward();
  input_->camera_moved();
}

void WindowStyle::OnKeyPress() {
  const char* symbol = Interactor->GetKeySym();
  if (symbol) input_->key(symbol, Interactor->GetControlKey() != 0);
}

}  // namespace isostack
