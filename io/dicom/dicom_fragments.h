#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace isostack {

/// Which fragments of compressed pixels belong to which frame: for each frame the index of its first
/// fragment, then the number of fragments. Empty when that cannot be told.
std::vector<std::size_t> frame_starts(const std::vector<std::string_view>& fragments, std::size_t frame_count);

/// Columns and rows that a JPEG, JPEG-LS or JPEG 2000 codestream says it holds.
std::optional<std::pair<int, int>> codestream_size(std::string_view codestream);

}  // namespace isostack
