#pragma once

#include <filesystem>
#include <vector>

#include "io/read_slices.h"
#include "io/volumes/stored_volume.h"
#include "io/write_options.h"
#include "recon/geometry/label_map.h"

namespace isostack {

/// Reads NIfTI, NRRD or MetaImage with its pose from the header. Throws InputError naming the file.
Volume<float> read_volume(const std::filesystem::path& path);

/// The grid of a volume file, a DICOM SEG or an evenly spaced series.
Grid read_grid(const std::filesystem::path& path, const ReadOptions& options = {});

/// A volume file as it stores its values, for writing it in another format.
StoredVolume read_stored_volume(const std::filesystem::path& path);

/// Writes NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr) or MetaImage (.mha, .mhd) with its pose; the stored type stays.
/// Whole file or none.
void write_volume(const StoredVolume& volume, const std::filesystem::path& path, const WriteOptions& options = {});

/// True when read_labels can read the file: a volume file, or a DICOM file that is a segmentation.
bool may_hold_labels(const std::filesystem::path& path);

/// Labels with what the file says about them: DICOM SEG, NRRD and NIfTI can hold names and colours. Throws InputError
/// naming the file, also when its values are not whole numbers.
LabelMap read_labels(const std::filesystem::path& path);

/// The same for planes anywhere: labels that lie on no even grid, as a DICOM SEG may have them, come as one map for
/// each plane; all others as one map.
std::vector<LabelMap> read_label_planes(const std::filesystem::path& path);

/// Writes labels as NIfTI, NRRD (.seg.nrrd keeps everything), MetaImage or DICOM SEG (.dcm). Whole file or none.
void write_labels(const LabelMap& labels, const std::filesystem::path& path, const WriteOptions& options = {});

}  // namespace isostack
