#include "io/dicom/inflate.h"

#include <zlib.h>

#include <array>
#include <limits>

namespace isostack {

std::optional<std::string> inflate_raw(std::string_view deflated, std::size_t most_bytes) {
  z_stream stream{};
  constexpr int raw_window_bits = -15;
  if (deflated.size() > std::numeric_limits<uInt>::max() || inflateInit2(&stream, raw_window_bits) != Z_OK)
    return std::nullopt;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(deflated.data()));  // zlib does not write there
  stream.avail_in = static_cast<uInt>(deflated.size());
  std::string inflated;
  std::array<char, 1 << 16> chunk;
  int status = Z_OK;
  while (status == Z_OK && inflated.size() <= most_bytes) {
    stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
    stream.avail_out = static_cast<uInt>(chunk.size());
    status = inflate(&stream, Z_NO_FLUSH);
    inflated.append(chunk.data(), chunk.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (status != Z_STREAM_END || inflated.size() > most_bytes) return std::nullopt;
  return inflated;
}

}  // namespace isostack
