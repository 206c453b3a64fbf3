#include "io/dicom/dicom_header.h"
#include "io/dicom/dicom_seg.h"
#include "tests/fuzz/fuzz_file.h"

namespace {

/// Compressed pixels are GDCM's to decode, in child processes: not here.
void read_segmentation(const std::filesystem::path& path) {
  const bool is_plain = isostack::read_dicom_header(path).pixel_offset != 0;
  if (is_plain)
    isostack::read_dicom_seg_planes(path);
  else
    isostack::read_dicom_seg_grid(path);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return isostack::fuzz::feed(isostack::fuzz::text_of(data, size), "input.dcm", read_segmentation);
}
