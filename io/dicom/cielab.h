#pragma once

#include <array>
#include <cstdint>

#include "recon/geometry/color.h"

namespace isostack {

/// L*, a*, b* as DICOM stores them in 16 bits (PS3.3, C.10.7.1.1): 0 ... 65535 stands for 0 ... 100, -128 ... 127
/// and -128 ... 127.
using DicomLab = std::array<std::uint16_t, 3>;

/// Relative to the white D65, as the programs that write DICOM segmentations take it (the colours they had in sRGB
/// come out whole). What lies outside sRGB is clipped.
Color color_from_lab(const DicomLab& lab);
DicomLab lab_from_color(const Color& color);

}  // namespace isostack
