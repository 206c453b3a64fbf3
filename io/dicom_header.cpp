#include "io/dicom_header.h"

#include <gdcmMediaStorage.h>
#include <gdcmReader.h>
#include <gdcmUIDs.h>

#include <cstring>
#include <fstream>
#include <locale>
#include <sstream>
#include <tuple>
#include <vector>

#include "io/dicom_structure.h"
#include "io/gdcm_setup.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

const gdcm::ByteValue* value_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  return data.FindDataElement(tag) ? data.GetDataElement(tag).GetByteValue() : nullptr;
}

std::string text(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  const gdcm::ByteValue* value = value_of(data, tag);
  if (!value) return {};
  std::string result(value->GetPointer(), value->GetLength());
  while (!result.empty() && (result.back() == ' ' || result.back() == '\0')) result.pop_back();
  while (!result.empty() && result.front() == ' ') result.erase(result.begin());
  return result;
}

/// Decimal strings, separated by backslashes; empty when any of them is not a number.
std::vector<double> numbers(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  std::vector<double> result;
  std::istringstream parts(text(data, tag));
  parts.imbue(std::locale::classic());
  for (std::string part; std::getline(parts, part, '\\');) {
    std::istringstream stream(part);
    stream.imbue(std::locale::classic());
    double number = 0;
    if (!(stream >> number)) return {};
    result.push_back(number);
  }
  return result;
}

std::optional<double> number(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  const std::vector<double> all = numbers(data, tag);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

/// GDCM has already swapped binary numbers to the machine's byte order.
int unsigned_short(const gdcm::DataSet& data, const gdcm::Tag& tag, int otherwise) {
  const gdcm::ByteValue* value = value_of(data, tag);
  std::uint16_t result = 0;
  if (!value || value->GetLength() < sizeof(result)) return otherwise;
  std::memcpy(&result, value->GetPointer(), sizeof(result));
  return result;
}

DicomKind kind_of(const gdcm::File& file) {
  gdcm::MediaStorage storage;
  storage.SetFromFile(file);
  if (storage == gdcm::MediaStorage::SegmentationStorage) return DicomKind::kSegmentation;
  if (storage == gdcm::MediaStorage::RTStructureSetStorage) return DicomKind::kStructureSet;
  return gdcm::MediaStorage::IsImage(storage) ? DicomKind::kImage : DicomKind::kOther;
}

std::string transfer_syntax_name(const gdcm::File& file) {
  gdcm::UIDs uids;
  const char* uid = gdcm::TransferSyntax::GetTSString(file.GetHeader().GetDataSetTransferSyntax());
  return uid && uids.SetFromUID(uid) && uids.GetName() ? uids.GetName() : "unknown transfer syntax";
}

void read_geometry(const gdcm::DataSet& data, DicomHeader& header) {
  if (const auto p = numbers(data, {0x0020, 0x0032}); p.size() == 3) header.position_mm = {p[0], p[1], p[2]};
  if (const auto o = numbers(data, {0x0020, 0x0037}); o.size() == 6)
    header.row_and_column = {{o[0], o[1], o[2]}, {o[3], o[4], o[5]}};
  // DICOM gives the distance between rows (along y) first.
  if (const auto s = numbers(data, {0x0028, 0x0030}); s.size() == 2) header.spacing_mm = {s[1], s[0]};
  header.slice_thickness_mm = number(data, {0x0018, 0x0050});
  header.spacing_between_slices_mm = number(data, {0x0018, 0x0088});
}

void read_pixel_format(const gdcm::DataSet& data, DicomHeader& header) {
  header.photometric = text(data, {0x0028, 0x0004});
  header.samples_per_pixel = unsigned_short(data, {0x0028, 0x0002}, 1);
  header.rows = unsigned_short(data, {0x0028, 0x0010}, 0);
  header.columns = unsigned_short(data, {0x0028, 0x0011}, 0);
  header.frames = static_cast<int>(number(data, {0x0028, 0x0008}).value_or(1));
  header.bits_allocated = unsigned_short(data, {0x0028, 0x0100}, 0);
  header.bits_stored = unsigned_short(data, {0x0028, 0x0101}, header.bits_allocated);
  header.is_signed = unsigned_short(data, {0x0028, 0x0103}, 0) == 1;
  header.slope = number(data, {0x0028, 0x1053}).value_or(1);
  header.intercept = number(data, {0x0028, 0x1052}).value_or(0);
}

[[noreturn]] void throw_truncated(const DicomHeader& header) {
  throw InputError(header.name, "the DICOM file is cut off or damaged", "copy the file again or take it out");
}

[[noreturn]] void throw_missing(const DicomHeader& header, const std::string& what) {
  throw InputError(header.name, "the slice has no " + what, "take it out (a localizer?) or repair its header");
}

}  // namespace

bool has_dicom_magic(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  char bytes[4] = {};
  stream.seekg(128);
  return stream.read(bytes, 4) && std::memcmp(bytes, "DICM", 4) == 0;
}

DicomHeader read_dicom_header(const std::filesystem::path& path) {
  set_up_gdcm();
  DicomHeader header;
  header.path = path;
  header.name = path.filename().string();
  const DicomStructure structure = walk_dicom(path);
  if (!structure.is_whole) throw_truncated(header);
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  const gdcm::Tag pixel_data(0x7fe0, 0x0010);
  if (!reader.ReadUpToTag(pixel_data)) throw_truncated(header);

  const gdcm::File& file = reader.GetFile();
  const gdcm::DataSet& data = file.GetDataSet();
  header.kind = kind_of(file);
  header.series_uid = text(data, {0x0020, 0x000e});
  header.modality = text(data, {0x0008, 0x0060});
  header.transfer_syntax = transfer_syntax_name(file);
  read_pixel_format(data, header);
  read_geometry(data, header);
  const bool lacks_image = !structure.has_pixels || header.rows == 0 || header.columns == 0;
  if (header.kind == DicomKind::kImage && lacks_image) throw_truncated(header);
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
