#include "cli/outputs.h"

#include "io/formats.h"
#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

std::vector<std::string_view> allowed_extensions(OutputPurpose purpose) {
  std::vector<std::string_view> extensions = purpose == OutputPurpose::kContoursOrLabels
                                                 ? extensions_with(&Format::write_contours)
                                                 : extensions_with(&Format::write_mesh);
  for (const std::string_view extension : extensions_with(&Format::write_labels)) extensions.push_back(extension);
  return extensions;
}

}  // namespace

bool is_label_file(const std::filesystem::path& path) { return writes_labels(path, DicomOutput::kStructureSet); }

bool writes_labels(const std::filesystem::path& path, DicomOutput dicom) {
  const Format* format = find_format(path, &Format::write_labels);
  return format && (!format->write_contours || dicom == DicomOutput::kSegmentation);  // DICOM has both
}

void require_writable(const std::filesystem::path& output, OutputPurpose purpose, DicomOutput dicom) {
  const bool known = writes_labels(output, dicom) || (purpose == OutputPurpose::kContoursOrLabels
                                                          ? find_format(output, &Format::write_contours) != nullptr
                                                          : find_format(output, &Format::write_mesh) != nullptr);
  if (!known) throw_unknown_extension(output, "this output", allowed_extensions(purpose));
  const std::filesystem::path folder = output.has_parent_path() ? output.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    throw InputError(output.string(), "its folder does not exist", "create " + folder.string());
}

void note_dropped_organs(const std::vector<ContourStack>& organs, const std::filesystem::path& output,
                         Session& session) {
  const Format* format = find_format(output, &Format::write_contours);
  if (!format || !format->drops_empty_organs) return;
  for (const ContourStack& organ : organs)
    if (point_count(organ) == 0)
      session.note(organ.name + ": it has no contours, so " + output.filename().string() +
                   " cannot hold it; .json, .vtp, .csl and RTSTRUCT can");
}

std::filesystem::path with_suffix(const std::filesystem::path& path, const std::string& suffix) {
  const std::string name = path.filename().string();
  const std::size_t dot = name.ends_with(".nii.gz") ? name.size() - 7 : name.rfind('.');
  return path.parent_path() / (name.substr(0, dot) + "_" + suffix + name.substr(dot));
}

}  // namespace isostack::cli
