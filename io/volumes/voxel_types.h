#pragma once

#include <cstdint>
#include <string>

namespace isostack {

/// Calls `call` with a zero of the C++ type that a value type ("int8" ... "uint64", "float", "double") names.
/// Returns false for other names.
template <class Call>
bool with_voxel_type(const std::string& value_type, Call call) {
  if (value_type == "int8")
    call(std::int8_t{});
  else if (value_type == "uint8")
    call(std::uint8_t{});
  else if (value_type == "int16")
    call(std::int16_t{});
  else if (value_type == "uint16")
    call(std::uint16_t{});
  else if (value_type == "int32")
    call(std::int32_t{});
  else if (value_type == "uint32")
    call(std::uint32_t{});
  else if (value_type == "int64")
    call(std::int64_t{});
  else if (value_type == "uint64")
    call(std::uint64_t{});
  else if (value_type == "float")
    call(float{});
  else if (value_type == "double")
    call(double{});
  else
    return false;
  return true;
}

}  // namespace isostack
