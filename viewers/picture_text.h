#pragma once

#include <string>

#include "recon/geometry/color.h"
#include "recon/geometry/picture.h"

namespace isostack {

struct TextLook {
  int height_pixels = 16;  ///< of the font
  Color ink = {51, 51, 51};
};

/// Writes one line of text, centred at `centre_x` and `centre_y` pixels from the left and top. What lies beyond the
/// picture is cut off. Needs no display and no font on the system.
void draw_text(const std::string& text, double centre_x, double centre_y, const TextLook& look, Picture& picture);

}  // namespace isostack
