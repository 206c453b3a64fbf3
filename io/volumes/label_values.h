#pragma once

#include <string>

#include "io/volumes/stored_volume.h"
#include "recon/geometry/label_map.h"

namespace isostack {

/// Whole numbers as labels, one layer per component. Numbers that do not fit into 1 ... 65535 get free values
/// and a segment with the number as its name. Throws InputError naming `where` when a value is not a whole number or
/// there are more than 65535 different ones.
LabelMap label_map_of(const StoredVolume& volume, const std::string& where);

/// The only layer. Throws InputError naming `where` and the format when there are several or none.
const LabelVolume& single_layer(const LabelMap& map, const std::string& where, const std::string& format);

}  // namespace isostack
