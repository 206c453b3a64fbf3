#include "viewers/screenshot.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "io/atomic_file.h"
#include "recon/geometry/errors.h"
#include "viewers/display.h"
#include "viewers/quiet_vtk.h"
#include "viewers/scene_points.h"
#include "viewers/scene_renderer.h"

namespace isostack {

namespace {

/// Drawn this much larger each way and averaged: smooth edges for lines, text and shading alike.
constexpr int oversampling = 2;

vtkNew<vtkUnsignedCharArray> draw(const Scene& scene, const ScreenshotOptions& options) {
  const int width = oversampling * options.width_pixels, height = oversampling * options.height_pixels;
  vtkNew<vtkRenderWindow> window;
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetMultiSamples(0);
  window->SetDPI(72);  // a point of a font is a pixel, whatever the screen
  window->SetSize(width, height);
  show_scene(scene,
             {.dark = options.dark,
              .view_from = options.view_from,
              .framed_points_mm = options.framed_points_mm,
              .marks = options.marks,
              .surface_opacity = options.surface_opacity},
             *window);
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels);
  if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(width) * height)
    throw InputError("display", "the picture could not be drawn", "try a smaller size, or run it under xvfb-run");
  return pixels;
}

/// Means over blocks of oversampling x oversampling pixels; VTK's rows come from the bottom.
Picture reduced(const unsigned char* rgba, const ScreenshotOptions& options) {
  Picture picture{.width_pixels = options.width_pixels, .height_pixels = options.height_pixels, .rgb = {}};
  picture.rgb.reserve(std::size_t{3} * static_cast<std::size_t>(options.width_pixels) *
                      static_cast<std::size_t>(options.height_pixels));
  const std::ptrdiff_t row_bytes = std::ptrdiff_t{4} * oversampling * options.width_pixels;
  constexpr int samples = oversampling * oversampling;
  for (int y = options.height_pixels - 1; y >= 0; --y)
    for (int x = 0; x < options.width_pixels; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        int sum = samples / 2;
        for (int dy = 0; dy < oversampling; ++dy)
          for (int dx = 0; dx < oversampling; ++dx)
            sum += rgba[(oversampling * y + dy) * row_bytes + 4 * (oversampling * x + dx) + channel];
        picture.rgb.push_back(static_cast<std::uint8_t>(sum / samples));
      }
  return picture;
}

vtkNew<vtkImageData> vtk_image_of(const Picture& picture) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width_pixels, picture.height_pixels, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::ptrdiff_t row_bytes = std::ptrdiff_t{3} * picture.width_pixels;
  for (int y = 0; y < picture.height_pixels; ++y)
    std::copy_n(picture.rgb.data() + y * row_bytes, row_bytes,
                static_cast<std::uint8_t*>(image->GetScalarPointer(0, picture.height_pixels - 1 - y, 0)));
  return image;
}

}  // namespace

Picture draw_picture(const Scene& scene, const ScreenshotOptions& options) {
  for (const int side : {options.width_pixels, options.height_pixels})
    if (side < 64 || side > 8000)
      throw InputError("screenshot", "its size is out of range", "ask for 64 to 8000 pixels a side");
  drawn_points(scene);  // a scene that cannot be drawn is said to be so, display or not
  const DisplayConnection display;
  const QuietVtk quiet;
  const vtkNew<vtkUnsignedCharArray> rgba = draw(scene, options);
  return reduced(rgba->GetPointer(0), options);
}

void save_screenshot(const Scene& scene, const std::filesystem::path& png, const ScreenshotOptions& options) {
  const Picture picture = draw_picture(scene, options);
  const QuietVtk quiet;
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(vtk_image_of(picture));
  writer->Write();
  vtkUnsignedCharArray& bytes = *writer->GetResult();
  write_whole_file(
      png, {reinterpret_cast<const char*>(bytes.GetPointer(0)), static_cast<std::size_t>(bytes.GetNumberOfTuples())});
}

}  // namespace isostack
