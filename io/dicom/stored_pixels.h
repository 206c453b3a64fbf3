#pragma once

#include "io/dicom/dicom_header.h"

namespace isostack {

/// Turns stored pixels of 8, 16 or 32 bits, in the machine's byte order, into grey values: the
/// header's stored bits are cut out, given their sign, and rescaled. Both hold `count` values.
void rescale_stored(const char* stored, const DicomHeader& header, std::size_t count, float* pixels);

}  // namespace isostack
