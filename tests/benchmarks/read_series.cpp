// read_series DIR: how long isostack takes to read the DICOM series in DIR (headers, geometry and pixels); least of
// five. read_series --make DIR SLICES: writes a series of 512 x 512 pixels of 16 bits to read.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "io/dicom/write_dicom.h"
#include "io/read_slices.h"
#include "recon/geometry/errors.h"
#include "recon/geometry/peak_memory.h"
#include "recon/geometry/stopwatch.h"

namespace {

/// Noise, so that nothing on the way can be clever about equal values.
isostack::SliceStack noise(int count) {
  constexpr int side = 512;
  isostack::SliceStack stack;
  unsigned state = 1;
  for (int k = 0; k < count; ++k) {
    isostack::Slice& slice = stack.slices.emplace_back();
    slice.pose.origin_mm.z() = k;
    slice.pixels.resize(side, side);
    for (float& value : slice.pixels.reshaped()) {
      state = state * 1664525 + 1013904223;
      value = static_cast<float>(state >> 20);
    }
  }
  return stack;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 4 && std::string(argv[1]) == "--make") {
      isostack::write_dicom_series(noise(std::stoi(argv[3])), argv[2]);
      return 0;
    }
    double least_s = 1e9;
    std::size_t slices = 0;
    for (int run = 0; run < 5; ++run) {
      const isostack::Stopwatch stopwatch;
      slices = isostack::read_slices(argc > 1 ? argv[1] : ".").slices.size();
      least_s = std::min(least_s, stopwatch.seconds());
    }
    fmt::print("seconds {:.3f}\npeak_gb {:.2f}\nremark {} slices, least of 5 runs\n", least_s,
               static_cast<double>(isostack::peak_memory_bytes()) / 1e9, slices);
  } catch (const isostack::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
