#pragma once

#include <string>
#include <vector>

#include "recon/geometry/picture.h"

namespace isostack {

struct CaptionedPicture {
  Picture picture;
  std::string caption;
};

/// All pictures in rows of at most nine, each with its caption below, on white. They are of one size. Needs no
/// display. Throws InputError when there is none or sizes differ.
Picture contact_sheet(const std::vector<CaptionedPicture>& pictures);

}  // namespace isostack
