#pragma once

#include <cstring>
#include <vector>

#include "io/volumes/volume_header.h"
#include "io/volumes/voxel_types.h"

namespace isostack {

/// A grey or label volume as its file stores it, so that nothing is lost from file to file.
struct StoredVolume {
  VolumeHeader header;
  std::vector<char> bytes;  ///< values of header.value_type, i fastest, in this machine's byte order
};

/// Calls call(index, value) for every value with the rescale applied, in the order of the bytes.
template <class Call>
void for_each_value(const StoredVolume& volume, Call call) {
  with_voxel_type(volume.header.value_type, [&]<class T>(T stored) {
    for (std::size_t i = 0; i < volume.bytes.size() / sizeof(T); ++i) {
      std::memcpy(&stored, volume.bytes.data() + i * sizeof(T), sizeof(T));
      call(i, volume.header.slope * static_cast<double>(stored) + volume.header.intercept);
    }
  });
}

/// The same values with slope 1 and intercept 0, in the narrowest type that holds each of them exactly and is not
/// narrower than the stored one; for formats without a rescale. Unchanged when there is no rescale.
StoredVolume with_rescale_applied(StoredVolume volume);

/// The values in the narrowest integer type, or float, that holds each of them exactly.
StoredVolume stored_volume_of(const Volume<float>& volume);

/// The same of signed distances in mm, positive inside, marked as such.
StoredVolume stored_distances_of(const Volume<float>& distances_mm);

}  // namespace isostack
