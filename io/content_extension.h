#pragma once

#include <cstdint>
#include <string_view>

namespace isostack {

/// The extension, such as ".ply", of the format that a file's first bytes (400 are enough for all) and its size show;
/// for data that come without a name. Empty when they show none of the formats that one file can hold.
std::string_view content_extension(std::string_view start, std::uintmax_t size_bytes);

}  // namespace isostack
