#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gdcm {
class DataSet;
}  // namespace gdcm

namespace isostack {

/// A DICOM tag as group << 16 | element.
using DicomTag = std::uint32_t;

/// The text of an element without padding; empty when it is missing.
std::string dicom_text(const gdcm::DataSet& data, DicomTag tag);

/// The bytes of an element as they are; empty when it is missing.
std::string_view dicom_bytes(const gdcm::DataSet& data, DicomTag tag);

/// Decimal or integer strings, separated by backslashes; empty when any of them is not a number.
std::vector<double> dicom_numbers(const gdcm::DataSet& data, DicomTag tag);
std::optional<double> dicom_number(const gdcm::DataSet& data, DicomTag tag);

/// Binary numbers: VR US, UL and FD. GDCM has already swapped them to the machine's byte order.
std::optional<double> dicom_uint16(const gdcm::DataSet& data, DicomTag tag);
std::optional<double> dicom_uint32(const gdcm::DataSet& data, DicomTag tag);
std::optional<double> dicom_float64(const gdcm::DataSet& data, DicomTag tag);

/// Date and time (VR DT, or DA with TM) as one number of seconds that grows with time.
std::optional<double> dicom_seconds(const std::string& date, const std::string& time);

/// The items of a sequence; empty when it is missing or none.
std::vector<gdcm::DataSet> dicom_items(const gdcm::DataSet& data, DicomTag tag);

}  // namespace isostack
