#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace isostack {

/// Inflates a deflate stream without header (RFC 1951); none when it is damaged, cut off or holds
/// more than `most_bytes`. Bytes after its end are ignored.
std::optional<std::string> inflate_raw(std::string_view deflated, std::size_t most_bytes);

}  // namespace isostack
