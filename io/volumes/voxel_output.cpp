#include "io/volumes/voxel_output.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <new>

#include "io/atomic_file.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

template <class T>
std::string interleaved(const LabelMap& map) {
  const std::size_t layers = map.layers.size(), voxels = map.layers.front().voxels.size();
  std::string bytes(layers * voxels * sizeof(T), '\0');
  for (std::size_t layer = 0; layer < layers; ++layer)
    for (std::size_t i = 0; i < voxels; ++i) {
      const T value = static_cast<T>(map.layers[layer].voxels[i]);
      std::memcpy(bytes.data() + (i * layers + layer) * sizeof(T), &value, sizeof(T));
    }
  return bytes;
}

}  // namespace

std::string deflated(std::span<const char> bytes, Deflate frame) {
  constexpr int level = 4;  // twice as fast as the default for a few per cent more bytes
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, frame == Deflate::gzip ? 15 + 16 : 15, 9, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string result;
  constexpr std::size_t at_once = 1 << 24;
  do {
    const std::span<const char> part = bytes.first(std::min(at_once, bytes.size()));
    bytes = bytes.subspan(part.size());
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));  // zlib does not write there
    stream.avail_in = static_cast<uInt>(part.size());
    do {
      const std::size_t before = result.size(), room = at_once / 8;
      result.resize(before + room);
      stream.next_out = reinterpret_cast<Bytef*>(result.data() + before);
      stream.avail_out = static_cast<uInt>(room);
      deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
      result.resize(before + room - stream.avail_out);
    } while (stream.avail_out == 0);
  } while (!bytes.empty());
  deflateEnd(&stream);
  return result;
}

void write_header_and_voxels(const std::filesystem::path& path, std::string_view header, std::span<const char> voxels) {
  AtomicFile file(path);
  std::ofstream stream(file.temporary(), std::ios::binary);
  stream.write(header.data(), static_cast<std::streamsize>(header.size()));
  stream.write(voxels.data(), static_cast<std::streamsize>(voxels.size()));
  stream.close();
  if (!stream) throw InputError(path.string(), "it cannot be written to the end", "check that the disk has free space");
  file.commit();
}

std::string interleaved_labels(const LabelMap& map, std::string& value_type) {
  const bool fits = std::all_of(map.layers.begin(), map.layers.end(), [](const LabelVolume& layer) {
    return std::all_of(layer.voxels.begin(), layer.voxels.end(), [](std::uint16_t value) { return value < 256; });
  });
  value_type = fits ? "uint8" : "uint16";
  return fits ? interleaved<std::uint8_t>(map) : interleaved<std::uint16_t>(map);
}

}  // namespace isostack
