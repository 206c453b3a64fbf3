#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/session.h"
#include "recon/geometry/contour.h"

namespace isostack::cli {

/// What a .dcm output holds; --as says so.
enum class DicomOutput { kStructureSet, kSegmentation };
enum class OutputPurpose { kContoursOrLabels, kSurfaceOrLabels };

/// Throws InputError before any work is done when an output could not be written at the end: its
/// folder is missing or the extension is not one of those `purpose` allows.
void require_writable(const std::filesystem::path& output, OutputPurpose purpose,
                      DicomOutput dicom = DicomOutput::kStructureSet);

/// True for a format that holds labels and not contours.
bool is_label_file(const std::filesystem::path& path);
/// The same for what `dicom` says of formats that hold both.
bool writes_labels(const std::filesystem::path& path, DicomOutput dicom);

/// Notes the organs without any contour that the format of `output` cannot hold.
void note_dropped_organs(const std::vector<ContourStack>& organs, const std::filesystem::path& output,
                         Session& session);

/// "skull.stl", "4" -> "skull_4.stl"; keeps double extensions such as .nii.gz whole.
std::filesystem::path with_suffix(const std::filesystem::path& path, const std::string& suffix);

}  // namespace isostack::cli
