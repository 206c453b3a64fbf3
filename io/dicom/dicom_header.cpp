#include "io/dicom/dicom_header.h"

#include <fmt/format.h>
#include <gdcmMediaStorage.h>
#include <gdcmUIDs.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <tuple>

#include "io/dicom/dicom_frames.h"
#include "io/dicom/dicom_reader.h"
#include "io/dicom/dicom_structure.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

DicomKind kind_of(const gdcm::File& file) {
  gdcm::MediaStorage storage;
  storage.SetFromFile(file);
  // GDCM does not know the storage of label maps.
  const bool is_label_map = dicom_text(file.GetDataSet(), 0x00080016) == "1.2.840.10008.5.1.4.1.1.66.7";
  if (is_label_map || storage == gdcm::MediaStorage::SegmentationStorage) return DicomKind::kSegmentation;
  if (storage == gdcm::MediaStorage::RTStructureSetStorage) return DicomKind::kStructureSet;
  return gdcm::MediaStorage::IsImage(storage) ? DicomKind::kImage : DicomKind::kOther;
}

std::string transfer_syntax_name(const gdcm::File& file) {
  gdcm::UIDs uids;
  const char* uid = gdcm::TransferSyntax::GetTSString(file.GetHeader().GetDataSetTransferSyntax());
  return uid && uids.SetFromUID(uid) && uids.GetName() ? uids.GetName() : "unknown transfer syntax";
}

int unsigned_short(const gdcm::DataSet& data, DicomTag tag, int otherwise) {
  return static_cast<int>(dicom_uint16(data, tag).value_or(otherwise));
}

/// A frame takes a bit at least, so the file bounds what it may claim.
int claimed_frames(const gdcm::DataSet& data, const DicomHeader& header) {
  const double frames = dicom_number(data, 0x00280008).value_or(1);
  std::error_code ignored;
  const auto bytes = static_cast<double>(std::filesystem::file_size(header.path, ignored));
  if (!(frames >= 0 && frames <= std::min(8 * bytes, 2e9)))
    throw InputError(header.name, fmt::format("it claims {:.0f} frames, more than a file of its size can hold", frames),
                     "the file is cut off or damaged; copy it again or take it out");
  return std::max(1, static_cast<int>(frames));
}

void read_pixel_format(const gdcm::DataSet& data, DicomHeader& header) {
  header.photometric = dicom_text(data, 0x00280004);
  header.samples_per_pixel = unsigned_short(data, 0x00280002, 1);
  header.rows = unsigned_short(data, 0x00280010, 0);
  header.columns = unsigned_short(data, 0x00280011, 0);
  header.frames = claimed_frames(data, header);
  header.bits_allocated = unsigned_short(data, 0x00280100, 0);
  header.bits_stored = unsigned_short(data, 0x00280101, header.bits_allocated);
  header.high_bit = unsigned_short(data, 0x00280102, header.bits_stored - 1);
  header.is_signed = unsigned_short(data, 0x00280103, 0) == 1;
}

void read_identity(const gdcm::DataSet& data, DicomHeader& header) {
  header.series_uid = dicom_text(data, 0x0020000e);
  header.instance_uid = dicom_text(data, 0x00080018);
  header.frame_of_reference_uid = dicom_text(data, 0x00200052);
  header.modality = dicom_text(data, 0x00080060);
  const bool is_scout = dicom_text(data, 0x00080008).find("LOCALIZER") != std::string::npos;
  header.is_localizer = is_scout && header.modality == "CT";  // MR scouts are slices like others
  header.was_compressed_lossy = dicom_text(data, 0x00282110) == "01";
}

/// Reads how pixels lie in the file.
void read_encoding(const gdcm::File& file, const DicomStructure& structure, DicomHeader& header) {
  const gdcm::TransferSyntax& syntax = file.GetHeader().GetDataSetTransferSyntax();
  header.transfer_syntax = transfer_syntax_name(file);
  header.is_compressed = syntax.IsEncapsulated();
  if (syntax == gdcm::TransferSyntax::ExplicitVRBigEndian)  // pixels of 8 bits may lie in words
    header.swapped_bytes = header.bits_allocated > 8 ? header.bits_allocated / 8 : structure.pixels_are_words ? 2 : 0;
  header.was_compressed_lossy = header.was_compressed_lossy || (syntax.IsLossy() && !syntax.IsLossless());
  header.pixel_offset = structure.pixel_offset;
  header.pixel_bytes = structure.pixel_bytes;
}

[[noreturn]] void throw_truncated(const DicomHeader& header) {
  throw InputError(header.name, "the DICOM file is cut off or damaged", "copy the file again or take it out");
}

[[noreturn]] void throw_without_image(const DicomHeader& header) {
  throw InputError(header.name, "the DICOM file holds no image (it lacks pixels, rows or columns)",
                   "take it out, or copy it again if it should hold one");
}

/// Sizes that the file cannot hold are refused before anything of that size is allocated.
void require_plausible_size(const DicomHeader& header) {
  constexpr double strongest_compression = 20000;  // an empty picture in JPEG 2000
  std::error_code ignored;
  const double most_bytes =
      header.pixel_offset != 0
          ? static_cast<double>(header.pixel_bytes)
          : strongest_compression * static_cast<double>(std::filesystem::file_size(header.path, ignored));
  const double bits = 1.0 * header.rows * header.columns * header.frames * std::max(1, header.bits_allocated);
  if (bits <= 8 * most_bytes) return;
  throw InputError(header.name,
                   fmt::format("it claims {} frame(s) of {} x {} pixels of {} bits, more than its pixel data hold",
                               header.frames, header.columns, header.rows, header.bits_allocated),
                   "the file is cut off or damaged; copy it again or take it out");
}

[[noreturn]] void throw_missing(const DicomHeader& header, const std::string& what) {
  throw InputError(header.name, "the slice has no " + what, "take it out (a localizer?) or repair its header");
}

}  // namespace

bool is_called_dicom(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension == ".dcm" || extension == ".ima";
}

DicomHeader read_dicom_header(const std::filesystem::path& path) {
  DicomHeader header;
  header.path = path;
  header.name = path.filename().string();
  const std::optional<DicomStart> start = find_dicom_start(path);
  if (!start)
    throw InputError(header.name, "it is not a DICOM file (it begins neither with \"DICM\" nor with a data set)",
                     "give DICOM files; their names do not matter");
  const DicomStructure structure = walk_dicom(path, *start);
  if (!structure.is_whole) throw_truncated(header);
  DicomReader reader(path, *start);
  const gdcm::Tag pixel_data(0x7fe0, 0x0010);
  std::set<gdcm::Tag> skipped;  // GDCM wants to read all of a deflated file
  if (!structure.is_deflated) skipped.insert(pixel_data);
  if (!reader->ReadUpToTag(pixel_data, skipped)) throw_truncated(header);

  const gdcm::File& file = reader->GetFile();
  const gdcm::DataSet& data = file.GetDataSet();
  header.kind = kind_of(file);
  read_identity(data, header);
  read_pixel_format(data, header);
  read_encoding(file, structure, header);
  read_frame_part(data, header);
  if (header.kind != DicomKind::kImage) return header;
  if (!structure.has_pixels || header.rows == 0 || header.columns == 0) throw_without_image(header);
  require_plausible_size(header);
  if (header.modality == "RTDOSE") header.slope = dicom_number(data, 0x3004000e).value_or(header.slope);
  header.frame_parts = read_frame_parts(data, header);
  return header;
}

SlicePose pose_of(const DicomHeader& header) {
  if (!header.position_mm) throw_missing(header, "position (ImagePositionPatient)");
  if (!header.row_and_column) throw_missing(header, "orientation (ImageOrientationPatient)");
  if (!header.spacing_mm) throw_missing(header, "pixel spacing (PixelSpacing)");
  SlicePose pose;
  pose.origin_mm = *header.position_mm;
  std::tie(pose.x_axis, pose.y_axis) = *header.row_and_column;
  pose.spacing_mm = *header.spacing_mm;
  return checked_pose(pose, header.name);
}

}  // namespace isostack
