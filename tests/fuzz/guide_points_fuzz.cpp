#include "io/contours/guide_points.h"
#include "tests/fuzz/fuzz_file.h"

/// The input is the table of points, and behind a line "====" the poses of the slices.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isostack;
  const std::string_view text = fuzz::text_of(data, size), border = "====\n";
  const std::size_t at = std::min(text.find(border), text.size());
  fuzz::feed(text.substr(std::min(at + border.size(), text.size())), "SliceInfoFile.txt");
  return fuzz::feed(text.substr(0, at), "points.txt", [](const auto& path) { read_guide_points(path); });
}
