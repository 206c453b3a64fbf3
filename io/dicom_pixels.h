#pragma once

#include "io/dicom_header.h"
#include "recon/geometry/slice.h"

namespace isostack {

/// Throws InputError naming the file when it is coloured or has several frames.
void require_grey_single_frame(const DicomHeader& header);

/// Decodes the pixels of one single-frame grey image; the rescale of the header is applied.
/// Throws InputError naming the file when they are coloured, multi-frame, cut off or damaged.
Image<float> read_dicom_pixels(const DicomHeader& header);

}  // namespace isostack
