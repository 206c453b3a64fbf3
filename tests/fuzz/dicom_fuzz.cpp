#include <algorithm>

#include "io/dicom/dicom_pixels.h"
#include "io/dicom/dicom_series.h"
#include "tests/fuzz/fuzz_file.h"

namespace {

/// Headers, order and geometry of one file's frames, and its pixels where they are plain: compressed ones are GDCM's
/// to decode, in child processes.
void read_images(const std::filesystem::path& path) {
  using namespace isostack;
  for (const DicomSeries& series : scan_dicom(path).series) {
    const OrderedSeries ordered = order_series(series, 1);
    series_warnings(ordered);
    const bool are_plain = std::all_of(ordered.files.begin(), ordered.files.end(),
                                       [](const DicomHeader& header) { return header.pixel_offset != 0; });
    if (are_plain) read_dicom_pixels(ordered.files);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return isostack::fuzz::feed(
      isostack::fuzz::text_of(data, size), "input.dcm", [](const auto& path) { isostack::read_dicom_header(path); },
      read_images);
}
