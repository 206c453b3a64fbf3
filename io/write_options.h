#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace isostack {

/// World axes of a written mesh. Files are in LPS, as DICOM; some programs expect RAS and do not ask.
enum class MeshAxes { lps, ras };

/// What some formats need to know beyond the data itself. A format takes what concerns it.
struct WriteOptions {
  /// The image series or volume that the written object refers to: RTSTRUCT and SEG name its
  /// slices, labels take its grid.
  std::optional<std::filesystem::path> like = std::nullopt;
  std::string like_series = {};   ///< which series of `like`, as ReadOptions::series
  bool identify = false;          ///< DICOM: copy the patient's name, ID and the like from `like`; otherwise left empty
  MeshAxes axes = MeshAxes::lps;  ///< STL, PLY, OBJ, VTP; glTF prescribes its own
  bool compressed = true;         ///< voxels of NRRD and MetaImage; NIfTI's are by its name
};

}  // namespace isostack
