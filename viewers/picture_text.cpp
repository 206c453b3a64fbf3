#include "viewers/picture_text.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "viewers/quiet_vtk.h"

namespace isostack {

namespace {

constexpr int points_per_inch = 72;  ///< a point of the font is a pixel

/// Lays an RGBA image, whose rows come from the bottom, over the picture with its top left corner at (left, top).
void lay_over(vtkImageData& text, const std::array<int, 2>& size, int left, int top, Picture& picture) {
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x) {
      const int column = left + x, row = top + y;
      if (column < 0 || row < 0 || column >= picture.width_pixels || row >= picture.height_pixels) continue;
      std::array<int, 6> extent{};
      text.GetExtent(extent.data());
      const auto* rgba =
          static_cast<const std::uint8_t*>(text.GetScalarPointer(extent[0] + x, extent[2] + size[1] - 1 - y, 0));
      std::uint8_t* rgb = picture.rgb.data() + std::size_t{3} * (static_cast<std::size_t>(row) *
                                                                     static_cast<std::size_t>(picture.width_pixels) +
                                                                 static_cast<std::size_t>(column));
      for (int channel = 0; channel < 3; ++channel)
        rgb[channel] =
            static_cast<std::uint8_t>(std::lround(rgb[channel] + rgba[3] / 255.0 * (rgba[channel] - rgb[channel])));
    }
}

}  // namespace

void draw_text(const std::string& text, double centre_x, double centre_y, const TextLook& look, Picture& picture) {
  const QuietVtk quiet;
  vtkNew<vtkTextProperty> property;
  property->SetFontFamilyToArial();  // comes with VTK
  property->SetFontSize(look.height_pixels);
  property->SetColor(look.ink.red / 255.0, look.ink.green / 255.0, look.ink.blue / 255.0);
  vtkNew<vtkImageData> image;
  std::array<int, 2> size{};
  if (text.empty() ||
      !vtkTextRenderer::GetInstance()->RenderString(property, text, image, size.data(), points_per_inch))
    return;
  lay_over(*image, size, static_cast<int>(std::lround(centre_x - size[0] / 2.0)),
           static_cast<int>(std::lround(centre_y - size[1] / 2.0)), picture);
}

}  // namespace isostack
