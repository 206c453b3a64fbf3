#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

#include <string>

namespace isostack {

enum class PointerButton { left, middle, right };

/// What a window does with the pointer and the keys. Pixels are counted from the window's bottom left. The first three
/// and wheel() answer whether they used it up; else it turns, moves or zooms the camera of the scene under it.
class WindowInput {
 public:
  virtual ~WindowInput() = default;
  virtual bool press(int x, int y, PointerButton button) = 0;
  virtual bool move(int x, int y) = 0;
  virtual bool release(int x, int y) = 0;
  virtual bool wheel(int x, int y, bool forward, bool control) = 0;
  virtual void key(const std::string& symbol, bool control) = 0;
  /// The camera has been moved.
  virtual void camera_moved() = 0;
};

/// Passes VTK's events to a WindowInput, or on to the camera. Private to the window.
class WindowStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static WindowStyle* New();
  vtkTypeMacro(WindowStyle, vtkInteractorStyleTrackballCamera);
  void set_input(WindowInput* input) { input_ = input; }

  void OnLeftButtonDown() override;
  void OnMiddleButtonDown() override;
  void OnRightButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMiddleButtonUp() override;
  void OnRightButtonUp() override;
  void OnMouseMove() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnKeyPress() override;
  void OnChar() override {}  // VTK's own keys would close the window

 private:
  WindowInput* input_ = nullptr;

  int x() const;
  int y() const;
  bool wheel(bool forward);
};

}  // namespace isostack
