#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace isostack {

/// RFC 4648, with padding.
std::string base64(std::span<const std::byte> bytes);

}  // namespace isostack
