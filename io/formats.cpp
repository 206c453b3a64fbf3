#include "io/formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "io/contours/contours_csl.h"
#include "io/contours/contours_edges.h"
#include "io/contours/contours_json.h"
#include "io/contours/contours_vtp.h"
#include "io/contours/guide_points.h"
#include "io/dicom/dicom_seg.h"
#include "io/dicom/dicom_series.h"
#include "io/dicom/rtstruct.h"
#include "io/images/image_stack.h"
#include "io/meshes/mesh_gltf.h"
#include "io/meshes/mesh_ply.h"
#include "io/meshes/mesh_vtk.h"
#include "io/volumes/metaimage.h"
#include "io/volumes/nifti.h"
#include "io/volumes/nrrd.h"
#include "recon/geometry/errors.h"

namespace isostack {

const std::vector<Format>& all_formats() {
  static const std::vector<Format> formats = {
      {.name = "DICOM",
       .extensions = {".dcm", ".ima"},
       .read_slices = read_dicom_slices,
       .read_contours = read_rtstruct,
       .holds_contours = is_rtstruct,
       .read_labels = read_dicom_seg,
       .read_label_planes = read_dicom_seg_planes,
       .holds_labels = is_dicom_seg,
       .write_labels = write_dicom_seg,
       .labels_may_overlap = true,
       .write_contours = write_rtstruct},
      {.name = "NIfTI",
       .extensions = {".nii.gz", ".nii"},
       .read_volume_header = read_nifti_header,
       .read_volume = read_nifti,
       .read_stored_volume = read_stored_nifti,
       .write_volume = write_nifti,
       .read_labels = read_nifti_labels,
       .write_labels = write_nifti_labels},
      {.name = "NRRD",
       .extensions = {".nrrd", ".nhdr"},
       .read_volume_header = read_nrrd_header,
       .read_volume = read_nrrd,
       .read_stored_volume = read_stored_nrrd,
       .write_volume = write_nrrd,
       .read_labels = read_nrrd_labels,
       .write_labels = write_nrrd_labels,
       .labels_may_overlap = true},
      {.name = "MetaImage",
       .extensions = {".mha", ".mhd"},
       .read_volume_header = read_metaimage_header,
       .read_volume = read_metaimage,
       .read_stored_volume = read_stored_metaimage,
       .write_volume = write_metaimage,
       .read_labels = read_metaimage_labels,
       .write_labels = write_metaimage_labels},
      {.name = "images",
       .extensions = {".png", ".tif", ".tiff", ".jpg", ".jpeg", ".bmp"},
       .read_slices = read_image_stack},
      {.name = "STL", .extensions = {".stl"}, .read_mesh = read_stl, .write_mesh = write_stl},
      {.name = "PLY", .extensions = {".ply"}, .read_mesh = read_ply, .write_mesh = write_ply},
      {.name = "OBJ", .extensions = {".obj"}, .read_mesh = read_obj, .write_mesh = write_obj},
      {.name = "VTP",
       .extensions = {".vtp"},
       .read_mesh = read_vtp_mesh,
       .read_contours = read_vtp_contours,
       .holds_contours = is_vtp_contours,
       .write_mesh = write_vtp_mesh,
       .write_contours = write_vtp_contours},
      {.name = "glTF", .extensions = {".gltf"}, .write_mesh = write_gltf, .prescribes_axes = true},
      {.name = "binary glTF", .extensions = {".glb"}, .write_mesh = write_glb, .prescribes_axes = true},
      {.name = "contour JSON",
       .extensions = {".json"},
       .read_contours = read_json_contours,
       .holds_contours = is_json_contours,
       .write_contours = write_json_contours},
      {.name = "CSL",
       .extensions = {".csl"},
       .read_contours = read_csl,
       .holds_contours = is_csl,
       .says_every_plane = true,
       .write_contours = write_csl},
      {.name = "labelled edges",
       .extensions = {".contour"},
       .read_contours = read_edge_contours,
       .holds_contours = is_edge_contours,
       .says_every_plane = true,
       .drops_empty_organs = true,
       .write_contours = write_edge_contours},
      {.name = "cardiac guide points",
       .extensions = {".txt"},
       .read_contours = read_guide_points,
       .holds_contours = holds_guide_points},
  };
  return formats;
}

bool has_extension_of(const std::filesystem::path& path, const Format& format) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::any_of(format.extensions.begin(), format.extensions.end(),
                     [&](std::string_view extension) { return name.ends_with(extension); });
}

void throw_unknown_extension(const std::filesystem::path& path, std::string_view purpose,
                             const std::vector<std::string_view>& extensions) {
  const std::string extension = path.extension().string();
  const std::string problem = extension.empty() ? fmt::format("no extension that tells the format of {}", purpose)
                                                : fmt::format("unknown extension {} for {}", extension, purpose);
  throw InputError(path.string(), problem, fmt::format("use {}", fmt::join(extensions, ", ")));
}

}  // namespace isostack
