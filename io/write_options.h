#pragma once

#include <filesystem>
#include <optional>

namespace isostack {

/// World axes of a written mesh. Files are in LPS, as DICOM; some programs expect RAS and do not ask.
enum class MeshAxes { lps, ras };

/// What some formats need to know beyond the data itself. A format takes what concerns it.
struct WriteOptions {
  /// The image series or volume that the written object refers to: RTSTRUCT and SEG name its
  /// slices, labels take its grid.
  std::optional<std::filesystem::path> like = std::nullopt;
  MeshAxes axes = MeshAxes::lps;  ///< STL, PLY, OBJ, VTP; glTF prescribes its own
};

}  // namespace isostack
