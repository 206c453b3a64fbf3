#pragma once

#include "io/dicom/dicom_header.h"
#include "io/dicom/dicom_values.h"

namespace isostack {

/// Reads what the data set itself says about one picture; what it does not say stays as in `frame`.
void read_frame_part(const gdcm::DataSet& data, DicomFrame& frame);

/// The frames of a multi-frame file, from the shared and per-frame functional groups of enhanced
/// images or from RT Dose's GridFrameOffsetVector; empty when the header does not place them.
/// `whole` is what the data set itself says. Throws InputError naming the file when the groups and
/// the number of frames disagree.
std::vector<DicomFrame> read_frame_parts(const gdcm::DataSet& data, const DicomHeader& whole);

}  // namespace isostack
