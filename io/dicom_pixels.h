#pragma once

#include "io/dicom_header.h"
#include "recon/geometry/slice.h"

namespace isostack {

/// Decodes the pixels of one single-frame grey image; the rescale of the header is applied.
/// Throws InputError naming the file when they are coloured, multi-frame, cut off or damaged.
Image<float> read_dicom_pixels(const DicomHeader& header);

}  // namespace isostack
