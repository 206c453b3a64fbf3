#include "io/volumes/voxel_decoder.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <span>

#include "io/volumes/voxel_types.h"
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
    constexpr std::size_t zlib_at_once = 1 << 30;
    for (; bytes.size() > zlib_at_once; bytes = bytes.subspan(zlib_at_once)) inflate_part(bytes.first(zlib_at_once));
    inflate_part(bytes);
  }

  void inflate_part(std::span<char> bytes) {
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
Stored value_at(const char* bytes, bool swapped) {
  std::array<char, sizeof(Stored)> raw;
  std::memcpy(raw.data(), bytes, sizeof(Stored));
  if (swapped) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Stored>(raw);
}

[[noreturn]] void throw_unsupported(const std::string& where) {
  throw InputError(where, "its voxel type is not supported", "convert it to integers or floats");
}

}  // namespace

int bytes_of_type(const std::string& value_type) {
  std::size_t bytes = 0;
  with_voxel_type(value_type, [&]<class T>(T) { bytes = sizeof(T); });
  return static_cast<int>(bytes);
}

std::vector<float> read_voxels(const VolumeHeader& header, const VoxelFile& file, const std::string& where) {
  if (header.components != 1)
    throw InputError(where, fmt::format("it has {} values per voxel", header.components),
                     "give one 3D volume of grey values or labels");
  ByteSource source(file, where);
  std::vector<float> voxels(header.grid.voxel_count());
  constexpr std::size_t values_at_once = 1 << 14;
  const bool known = with_voxel_type(header.value_type, [&]<class T>(T) {
    std::vector<char> buffer(values_at_once * sizeof(T));
    for (std::size_t begin = 0; begin < voxels.size(); begin += values_at_once) {
      const std::size_t count = std::min(values_at_once, voxels.size() - begin);
      source.fill(std::span(buffer).first(count * sizeof(T)));
      for (std::size_t i = 0; i < count; ++i) {
        const auto stored = static_cast<double>(value_at<T>(buffer.data() + i * sizeof(T), file.swapped));
        voxels[begin + i] = static_cast<float>(header.slope * stored + header.intercept);
      }
    }
  });
  if (!known) throw_unsupported(where);
  return voxels;
}

StoredVolume read_stored_voxels(const VolumeHeader& header, const VoxelFile& file, const std::string& where) {
  const auto value_bytes = static_cast<std::size_t>(bytes_of_type(header.value_type));
  if (value_bytes == 0) throw_unsupported(where);
  ByteSource source(file, where);
  StoredVolume volume{header, {}};
  volume.bytes.resize(header.grid.voxel_count() * static_cast<std::size_t>(header.components) * value_bytes);
  source.fill(volume.bytes);
  if (file.swapped)
    for (auto value = volume.bytes.begin(); value != volume.bytes.end(); value += static_cast<long>(value_bytes))
      std::reverse(value, value + static_cast<long>(value_bytes));
  return volume;
}

}  // namespace isostack
