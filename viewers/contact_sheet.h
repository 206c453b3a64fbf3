#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recon/geometry/color.h"
#include "recon/geometry/picture.h"

namespace isostack {

struct CaptionedPicture {
  Picture picture;
  std::string caption;
};

struct ContactSheetLook {
  std::size_t columns = 9;  ///< at most
  Color ground = {255, 255, 255};
  Color ink = {51, 51, 51};
};

/// All pictures in rows, each with its caption below. They are of one size. Needs no display. Throws InputError when
/// there is none or sizes differ.
Picture contact_sheet(const std::vector<CaptionedPicture>& pictures, const ContactSheetLook& look = {});

}  // namespace isostack
