#include "io/dicom/dicom_fragments.h"

#include <numeric>

namespace isostack {

namespace {

std::size_t byte_at(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

std::size_t number_at(std::string_view bytes, std::size_t at, std::size_t length) {
  std::size_t number = 0;
  for (std::size_t i = at; i < at + length; ++i) number = number << 8 | byte_at(bytes, i);
  return number;
}

bool begins_jpeg2000(std::string_view bytes) { return bytes.starts_with("\xff\x4f\xff\x51"); }
bool begins_jpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8"); }

/// The markers of a frame's header are FFC0 to FFCF but three, and FFF7 in JPEG-LS.
bool is_frame_header(std::size_t marker) {
  return (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) || marker == 0xf7;
}

}  // namespace

std::vector<std::size_t> frame_starts(const std::vector<std::string_view>& fragments, std::size_t frame_count) {
  std::vector<std::size_t> starts;
  if (fragments.size() == frame_count) {
    starts.resize(frame_count);
    std::iota(starts.begin(), starts.end(), 0);
  } else if (frame_count == 1 && !fragments.empty()) {
    starts = {0};
  } else {
    for (std::size_t i = 0; i < fragments.size(); ++i)
      if (begins_jpeg(fragments[i]) || begins_jpeg2000(fragments[i])) starts.push_back(i);
    if (starts.size() != frame_count || starts.front() != 0) return {};
  }
  starts.push_back(fragments.size());
  return starts;
}

std::optional<std::pair<int, int>> codestream_size(std::string_view bytes) {
  const auto size = [](std::size_t columns, std::size_t rows) {
    return std::pair(static_cast<int>(columns), static_cast<int>(rows));
  };
  if (begins_jpeg2000(bytes) && bytes.size() >= 24)  // SIZ: extent less offset of the reference grid
    return size(number_at(bytes, 8, 4) - number_at(bytes, 16, 4), number_at(bytes, 12, 4) - number_at(bytes, 20, 4));
  if (!begins_jpeg(bytes)) return std::nullopt;
  for (std::size_t at = 2; at + 9 <= bytes.size() && byte_at(bytes, at) == 0xff;) {
    const std::size_t marker = byte_at(bytes, at + 1);
    if (marker == 0xff) {  // fill byte
      ++at;
      continue;
    }
    if (is_frame_header(marker)) return size(number_at(bytes, at + 7, 2), number_at(bytes, at + 5, 2));
    at += 2 + number_at(bytes, at + 2, 2);
  }
  return std::nullopt;
}

}  // namespace isostack
