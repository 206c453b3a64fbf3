#pragma once

#include <vtkNew.h>

#include "recon/geometry/picture.h"
#include "viewers/display.h"
#include "viewers/quiet_vtk.h"

class vtkRenderWindow;

namespace isostack {

/// A window that nobody sees, to draw pictures with. VTK is silent while it lives.
class OffscreenWindow {
 public:
  /// Throws InputError when there is no display to draw with, or the size is not 64..8000 pixels a side.
  OffscreenWindow(int width_pixels, int height_pixels);
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  /// Larger than the pictures: sizes in pixels follow from the renderers in it.
  vtkRenderWindow& window() const { return *window_; }

  /// Draws what is in the window. Throws InputError when that fails.
  Picture draw();

  /// Throws InputError when the size is not 64..8000 pixels a side.
  static void require_size(int width_pixels, int height_pixels);

 private:
  int width_pixels_, height_pixels_;
  DisplayConnection display_;
  QuietVtk quiet_;
  vtkNew<vtkRenderWindow> window_;
};

}  // namespace isostack
