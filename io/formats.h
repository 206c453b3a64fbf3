#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/contours/contour_file.h"
#include "io/read_slices.h"
#include "io/volumes/stored_volume.h"
#include "io/volumes/volume_header.h"
#include "io/write_options.h"
#include "recon/geometry/contour.h"
#include "recon/geometry/label_map.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"

namespace isostack {

/// One file format and what can be done with it; null: not supported. A new format is one more
/// entry of all_formats().
struct Format {
  using Path = std::filesystem::path;

  std::string_view name;
  std::vector<std::string_view> extensions;  ///< lower case, with the dot

  SliceStack (*read_slices)(const Path&, const ReadOptions&, const Progress&) = nullptr;
  VolumeHeader (*read_volume_header)(const Path&) = nullptr;  ///< formats that hold one grid of voxels
  Volume<float> (*read_volume)(const Path&) = nullptr;
  StoredVolume (*read_stored_volume)(const Path&) = nullptr;
  void (*write_volume)(const StoredVolume&, const Path&, const WriteOptions&) = nullptr;
  TriangleMesh (*read_mesh)(const Path&) = nullptr;
  ContourFile (*read_contours)(const Path&, const ReadOptions&) = nullptr;
  bool (*holds_contours)(const Path&) = nullptr;  ///< goes with read_contours
  LabelMap (*read_labels)(const Path&) = nullptr;
  std::vector<LabelMap> (*read_label_planes)(const Path&) = nullptr;  ///< formats whose planes may be uneven
  bool (*holds_labels)(const Path&) = nullptr;  ///< goes with read_labels; null: any file of the format may be labels
  void (*write_labels)(const LabelMap&, const Path&, const WriteOptions&) = nullptr;
  bool labels_may_overlap = false;  ///< of written labels: more than one layer
  void (*write_mesh)(const TriangleMesh&, const Path&) = nullptr;
  bool prescribes_axes = false;     ///< of meshes: the format itself says where up is
  bool says_every_plane = false;    ///< of written contours: an organ without any on a plane is absent there
  bool drops_empty_organs = false;  ///< of written contours: an organ without any at all leaves no trace
  void (*write_contours)(const std::vector<ContourStack>&, const Path&, const WriteOptions&) = nullptr;
};

/// Every format the library knows.
const std::vector<Format>& all_formats();

/// True when the file name ends in one of the format's extensions, in any case.
bool has_extension_of(const std::filesystem::path& path, const Format& format);

/// "unknown extension .xyz for a mesh" as InputError, with the extensions that would do.
[[noreturn]] void throw_unknown_extension(const std::filesystem::path& path, std::string_view purpose,
                                          const std::vector<std::string_view>& extensions);

/// The format of `path`, by its extension, among those with the ability, such as
/// &Format::write_mesh. Null when there is none.
template <class Ability>
const Format* find_format(const std::filesystem::path& path, Ability Format::*ability) {
  for (const Format& format : all_formats())
    if (format.*ability && has_extension_of(path, format)) return &format;
  return nullptr;
}

/// All extensions with the ability, in the table's order.
template <class Ability>
std::vector<std::string_view> extensions_with(Ability Format::*ability) {
  std::vector<std::string_view> extensions;
  for (const Format& format : all_formats())
    if (format.*ability) extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
  return extensions;
}

/// As find_format, but throws InputError listing what is supported; `purpose` completes
/// "unknown extension .xyz for ...".
template <class Ability>
const Format& format_for(const std::filesystem::path& path, Ability Format::*ability, std::string_view purpose) {
  const Format* format = find_format(path, ability);
  if (!format) throw_unknown_extension(path, purpose, extensions_with(ability));
  return *format;
}

}  // namespace isostack
