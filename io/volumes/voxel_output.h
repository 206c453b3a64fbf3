#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "recon/geometry/label_map.h"

namespace isostack {

enum class Deflate { gzip, zlib };

/// The bytes compressed by deflate, within gzip's or zlib's frame.
std::string deflated(std::span<const char> bytes, Deflate frame);

/// Writes one file: the header's text, then the voxels. Whole or not at all.
/// Throws InputError naming the file when it cannot be written.
void write_header_and_voxels(const std::filesystem::path& path, std::string_view header, std::span<const char> voxels);

/// The layers' values, all of a voxel together, as uint8 if each fits and else as uint16; which of the two is told in
/// `value_type`.
std::string interleaved_labels(const LabelMap& map, std::string& value_type);

}  // namespace isostack
