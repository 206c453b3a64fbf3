#include "io/volumes/nifti.h"
#include "tests/fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return isostack::fuzz::feed(isostack::fuzz::text_of(data, size), "input.nii", isostack::read_nifti,
                              isostack::read_nifti_labels);
}
