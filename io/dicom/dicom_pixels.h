#pragma once

#include <optional>
#include <vector>

#include "io/dicom/dicom_header.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/progress.h"
#include "recon/geometry/slice.h"

namespace isostack {

/// Throws InputError naming the file when it is coloured or has pixels of an unsupported kind.
void require_grey(const DicomHeader& header);

/// Reads the pixels of grey pictures, one per header (one frame each, see frames_of); the headers'
/// rescale is applied. Uncompressed pixels are read by all threads, others decoded by GDCM in child
/// processes, so that a picture which GDCM cannot bear is refused like any other.
/// Throws InputError naming the file when they are coloured, cut off or damaged.
std::vector<Image<float>> read_dicom_pixels(const std::vector<DicomHeader>& headers, const Progress& progress = {});

/// One entry per picture in each: the image, or why there is none.
struct DicomPictures {
  std::vector<Image<float>> images;
  std::vector<std::optional<InputError>> failures;
};

/// The same for callers who can do without some: pictures that are cut off or damaged are failures.
DicomPictures read_dicom_pictures(const std::vector<DicomHeader>& headers, const Progress& progress = {});

}  // namespace isostack
