#include "io/volumes/stored_volume.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "io/volumes/voxel_decoder.h"

namespace isostack {

namespace {

template <class T>
bool holds(double value) {
  if constexpr (std::is_integral_v<T>)
    return value == std::floor(value) && value >= static_cast<double>(std::numeric_limits<T>::min()) &&
           value <= static_cast<double>(std::numeric_limits<T>::max());
  else
    return std::isnan(value) || static_cast<double>(static_cast<T>(value)) == value;
}

constexpr std::array<const char*, 8> narrowest_first = {"uint8",  "int8",  "uint16", "int16",
                                                        "uint32", "int32", "float",  "double"};

/// Stores the values that for_each(call) hands to call(index, value).
template <class ForEach>
void store(ForEach for_each, std::size_t count, int least_bytes, StoredVolume& volume) {
  for (const char* type : narrowest_first) {
    if (bytes_of_type(type) < least_bytes) continue;
    bool fits = true;
    with_voxel_type(type, [&]<class T>(T) {
      for_each([&](std::size_t, double value) { fits = fits && holds<T>(value); });
      if (!fits) return;
      std::vector<char> bytes(count * sizeof(T));
      for_each([&](std::size_t i, double value) {
        const T stored = static_cast<T>(value);
        std::memcpy(bytes.data() + i * sizeof(T), &stored, sizeof(T));
      });
      volume.bytes = std::move(bytes);
    });
    if (!fits) continue;
    volume.header.value_type = type;
    return;
  }
}

}  // namespace

StoredVolume with_rescale_applied(StoredVolume volume) {
  if (volume.header.slope == 1 && volume.header.intercept == 0) return volume;
  StoredVolume result{volume.header, {}};
  const int value_bytes = bytes_of_type(volume.header.value_type);
  store([&](auto call) { for_each_value(volume, call); }, volume.bytes.size() / static_cast<std::size_t>(value_bytes),
        value_bytes, result);
  result.header.slope = 1;
  result.header.intercept = 0;
  return result;
}

StoredVolume stored_volume_of(const Volume<float>& volume) {
  StoredVolume stored;
  stored.header.grid = volume.grid;
  const auto each_voxel = [&](auto call) {
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) call(i, static_cast<double>(volume.voxels[i]));
  };
  store(each_voxel, volume.voxels.size(), 1, stored);
  return stored;
}

StoredVolume stored_distances_of(const Volume<float>& distances_mm) {
  StoredVolume stored = stored_volume_of(distances_mm);
  stored.header.is_distance = true;
  return stored;
}

}  // namespace isostack
