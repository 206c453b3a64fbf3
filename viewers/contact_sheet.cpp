#include "viewers/contact_sheet.h"

#include <algorithm>
#include <cstddef>

#include "recon/geometry/errors.h"
#include "viewers/picture_text.h"

namespace isostack {

namespace {

constexpr int gap_pixels = 8;

void lay_in(const Picture& part, int left, int top, Picture& whole) {
  for (int y = 0; y < part.height_pixels; ++y) {
    const auto from = part.rgb.begin() + std::ptrdiff_t{3} * y * part.width_pixels;
    std::copy_n(from, std::ptrdiff_t{3} * part.width_pixels,
                whole.rgb.begin() + std::ptrdiff_t{3} * (std::ptrdiff_t{top + y} * whole.width_pixels + left));
  }
}

}  // namespace

Picture contact_sheet(const std::vector<CaptionedPicture>& pictures, const ContactSheetLook& look) {
  if (pictures.empty()) throw InputError("contact sheet", "there is no picture", "give at least one");
  const int width = pictures.front().picture.width_pixels, height = pictures.front().picture.height_pixels;
  for (const CaptionedPicture& each : pictures)
    if (each.picture.width_pixels != width || each.picture.height_pixels != height)
      throw InputError("contact sheet", "its pictures are not of one size", "draw all in one frame");
  const std::size_t rows = (pictures.size() + look.columns - 1) / look.columns;
  const std::size_t columns = (pictures.size() + rows - 1) / rows;
  const TextLook text{.height_pixels = std::clamp(width / 11, 11, 28), .ink = look.ink};
  const int caption_pixels = 2 * text.height_pixels;
  const int step_x = width + gap_pixels, step_y = height + caption_pixels + gap_pixels;
  Picture sheet{.width_pixels = static_cast<int>(columns) * step_x + gap_pixels,
                .height_pixels = static_cast<int>(rows) * step_y + gap_pixels,
                .rgb = {}};
  const std::size_t sheet_pixels =
      static_cast<std::size_t>(sheet.width_pixels) * static_cast<std::size_t>(sheet.height_pixels);
  sheet.rgb.reserve(3 * sheet_pixels);
  for (std::size_t i = 0; i < sheet_pixels; ++i)
    sheet.rgb.insert(sheet.rgb.end(), {look.ground.red, look.ground.green, look.ground.blue});
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int left = gap_pixels + static_cast<int>(i % columns) * step_x;
    const int top = gap_pixels + static_cast<int>(i / columns) * step_y;
    lay_in(pictures[i].picture, left, top, sheet);
    draw_text(pictures[i].caption, left + width / 2.0, top + height + caption_pixels / 2.0, text, sheet);
  }
  return sheet;
}

}  // namespace isostack
