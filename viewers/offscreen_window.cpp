#include "viewers/offscreen_window.h"

#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>
#include <cstdint>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// Drawn this much larger each way and averaged: smooth edges for lines, text and shading alike.
constexpr int oversampling = 2;

/// Means over blocks of oversampling x oversampling pixels; VTK's rows come from the bottom.
Picture reduced(const unsigned char* rgba, int width_pixels, int height_pixels) {
  Picture picture{.width_pixels = width_pixels, .height_pixels = height_pixels, .rgb = {}};
  picture.rgb.reserve(std::size_t{3} * static_cast<std::size_t>(width_pixels) *
                      static_cast<std::size_t>(height_pixels));
  const std::ptrdiff_t row_bytes = std::ptrdiff_t{4} * oversampling * width_pixels;
  constexpr int samples = oversampling * oversampling;
  for (int y = height_pixels - 1; y >= 0; --y)
    for (int x = 0; x < width_pixels; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        int sum = samples / 2;
        for (int dy = 0; dy < oversampling; ++dy)
          for (int dx = 0; dx < oversampling; ++dx)
            sum += rgba[(oversampling * y + dy) * row_bytes + std::ptrdiff_t{4} * (oversampling * x + dx) + channel];
        picture.rgb.push_back(static_cast<std::uint8_t>(sum / samples));
      }
  return picture;
}

}  // namespace

void OffscreenWindow::require_size(int width_pixels, int height_pixels) {
  for (const int side : {width_pixels, height_pixels})
    if (side < 64 || side > 8000)
      throw InputError("screenshot", "its size is out of range", "ask for 64 to 8000 pixels a side");
}

OffscreenWindow::OffscreenWindow(int width_pixels, int height_pixels)
    : width_pixels_((require_size(width_pixels, height_pixels), width_pixels)), height_pixels_(height_pixels) {
  window_->SetShowWindow(false);
  window_->SetUseOffScreenBuffers(true);
  window_->SetMultiSamples(0);
  window_->SetDPI(72);  // a point of a font is a pixel, whatever the screen
  window_->SetSize(oversampling * width_pixels, oversampling * height_pixels);
}

OffscreenWindow::~OffscreenWindow() = default;

Picture OffscreenWindow::draw() {
  window_->Render();
  const int width = oversampling * width_pixels_, height = oversampling * height_pixels_;
  vtkNew<vtkUnsignedCharArray> rgba;
  window_->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, rgba);
  if (rgba->GetNumberOfTuples() != static_cast<vtkIdType>(width) * height)
    throw InputError("display", "the picture could not be drawn", "try a smaller size, or run it under xvfb-run");
  return reduced(rgba->GetPointer(0), width_pixels_, height_pixels_);
}

}  // namespace isostack
