#include "io/voxel_decoder.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <span>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

[[noreturn]] void throw_cut_off(const std::string& where) {
  throw InputError(where, "its voxels are cut off or damaged", "copy the file again");
}

/// Gives the bytes of a voxel file in order, inflated if need be.
class ByteSource {
 public:
  ByteSource(const VoxelFile& file, std::string where)
      : stream_(file.path, std::ios::binary), compressed_(file.compressed), where_(std::move(where)) {
    // Compressed NIfTI counts the offset in the inflated bytes.
    if (!compressed_ || !file.offset_is_inflated) stream_.seekg(static_cast<std::streamoff>(file.offset_bytes));
    constexpr int gzip_or_zlib = 15 + 32;  // largest window, header recognised
    if (compressed_ && inflateInit2(&inflater_, gzip_or_zlib) != Z_OK) throw_cut_off(where_);
    if (compressed_ && file.offset_is_inflated) skip(file.offset_bytes);
  }
  ~ByteSource() {
    if (compressed_) inflateEnd(&inflater_);
  }
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  void fill(std::span<char> bytes) {
    if (compressed_)
      inflate_into(bytes);
    else if (!stream_.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
      throw_cut_off(where_);
  }

 private:
  void skip(std::uintmax_t count) {
    std::array<char, 4096> unused;
    for (; count > 0; count -= std::min<std::uintmax_t>(count, unused.size()))
      fill(std::span(unused).first(std::min<std::uintmax_t>(count, unused.size())));
  }

  void inflate_into(std::span<char> bytes) {
    inflater_.next_out = reinterpret_cast<Bytef*>(bytes.data());
    inflater_.avail_out = static_cast<uInt>(bytes.size());
    while (inflater_.avail_out > 0) {
      if (inflater_.avail_in == 0) {
        stream_.read(deflated_.data(), static_cast<std::streamsize>(deflated_.size()));
        inflater_.next_in = reinterpret_cast<Bytef*>(deflated_.data());
        inflater_.avail_in = static_cast<uInt>(stream_.gcount());
        if (inflater_.avail_in == 0) throw_cut_off(where_);
      }
      const int result = ::inflate(&inflater_, Z_NO_FLUSH);
      // A gzip file may consist of several members.
      if (result == Z_STREAM_END ? inflateReset(&inflater_) != Z_OK : result != Z_OK) throw_cut_off(where_);
    }
  }

  std::ifstream stream_;
  bool compressed_;
  std::string where_;
  z_stream inflater_{};
  std::array<char, 1 << 16> deflated_;
};

template <class Stored>
float rescaled(const char* bytes, bool swapped, const VolumeHeader& header) {
  std::array<char, sizeof(Stored)> raw;
  std::memcpy(raw.data(), bytes, sizeof(Stored));
  if (swapped) std::reverse(raw.begin(), raw.end());
  Stored stored;
  std::memcpy(&stored, raw.data(), sizeof(Stored));
  return static_cast<float>(header.slope * static_cast<double>(stored) + header.intercept);
}

struct ValueType {
  std::string_view name;
  int bytes;
  float (*read)(const char* bytes, bool swapped, const VolumeHeader& header);
};
constexpr ValueType value_types[] = {
    {"int8", 1, rescaled<std::int8_t>},   {"uint8", 1, rescaled<std::uint8_t>},
    {"int16", 2, rescaled<std::int16_t>}, {"uint16", 2, rescaled<std::uint16_t>},
    {"int32", 4, rescaled<std::int32_t>}, {"uint32", 4, rescaled<std::uint32_t>},
    {"int64", 8, rescaled<std::int64_t>}, {"uint64", 8, rescaled<std::uint64_t>},
    {"float", 4, rescaled<float>},        {"double", 8, rescaled<double>},
};

const ValueType* find_type(const std::string& name) {
  const auto* found = std::find_if(std::begin(value_types), std::end(value_types),
                                   [&](const ValueType& type) { return type.name == name; });
  return found == std::end(value_types) ? nullptr : found;
}

}  // namespace

int bytes_of_type(const std::string& value_type) {
  const ValueType* type = find_type(value_type);
  return type ? type->bytes : 0;
}

std::vector<float> read_voxels(const VolumeHeader& header, const VoxelFile& file, const std::string& where) {
  const ValueType* type = find_type(header.value_type);
  if (!type) throw InputError(where, "its voxel type is not supported", "convert it to integers or floats");
  ByteSource source(file, where);
  std::vector<float> voxels(header.grid.voxel_count());
  const auto bytes = static_cast<std::size_t>(type->bytes);
  constexpr std::size_t values_at_once = 1 << 14;
  std::vector<char> buffer(values_at_once * bytes);
  for (std::size_t begin = 0; begin < voxels.size(); begin += values_at_once) {
    const std::size_t count = std::min(values_at_once, voxels.size() - begin);
    source.fill(std::span(buffer).first(count * bytes));
    for (std::size_t i = 0; i < count; ++i)
      voxels[begin + i] = type->read(buffer.data() + i * bytes, file.swapped, header);
  }
  return voxels;
}

}  // namespace isostack
