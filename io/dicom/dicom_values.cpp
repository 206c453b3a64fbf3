#include "io/dicom/dicom_values.h"

#include <gdcmDataSet.h>
#include <gdcmSequenceOfItems.h>

#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>

namespace isostack {

namespace {

gdcm::Tag to_gdcm(DicomTag tag) { return {static_cast<std::uint16_t>(tag >> 16), static_cast<std::uint16_t>(tag)}; }

const gdcm::ByteValue* value_of(const gdcm::DataSet& data, DicomTag tag) {
  return data.FindDataElement(to_gdcm(tag)) ? data.GetDataElement(to_gdcm(tag)).GetByteValue() : nullptr;
}

template <class Number>
std::optional<double> binary(const gdcm::DataSet& data, DicomTag tag) {
  const gdcm::ByteValue* value = value_of(data, tag);
  Number result = 0;
  if (!value || value->GetLength() < sizeof(result)) return std::nullopt;
  std::memcpy(&result, value->GetPointer(), sizeof(result));
  const auto number = static_cast<double>(result);
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// The number in digits [begin, begin + length) of the text, 0 where it ends earlier.
double digits(const std::string& text, std::size_t begin, std::size_t length) {
  double result = 0;
  for (std::size_t i = begin; i < begin + length; ++i)
    result = 10 * result + (i < text.size() && text[i] >= '0' && text[i] <= '9' ? text[i] - '0' : 0);
  return result;
}

}  // namespace

std::string dicom_text(const gdcm::DataSet& data, DicomTag tag) {
  const gdcm::ByteValue* value = value_of(data, tag);
  if (!value) return {};
  std::string result(value->GetPointer(), value->GetLength());
  while (!result.empty() && (result.back() == ' ' || result.back() == '\0')) result.pop_back();
  while (!result.empty() && result.front() == ' ') result.erase(result.begin());
  return result;
}

std::string_view dicom_bytes(const gdcm::DataSet& data, DicomTag tag) {
  const gdcm::ByteValue* value = value_of(data, tag);
  return value ? std::string_view(value->GetPointer(), value->GetLength()) : std::string_view();
}

std::vector<double> dicom_numbers(const gdcm::DataSet& data, DicomTag tag) {
  std::vector<double> result;
  std::istringstream parts(dicom_text(data, tag));
  for (std::string part; std::getline(parts, part, '\\');) {
    std::istringstream stream(part);
    stream.imbue(std::locale::classic());
    double number = 0;
    if (!(stream >> number)) return {};
    result.push_back(number);
  }
  return result;
}

std::optional<double> dicom_number(const gdcm::DataSet& data, DicomTag tag) {
  const std::vector<double> all = dicom_numbers(data, tag);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

std::optional<double> dicom_uint16(const gdcm::DataSet& data, DicomTag tag) { return binary<std::uint16_t>(data, tag); }
std::optional<double> dicom_uint32(const gdcm::DataSet& data, DicomTag tag) { return binary<std::uint32_t>(data, tag); }
std::optional<double> dicom_float64(const gdcm::DataSet& data, DicomTag tag) { return binary<double>(data, tag); }

std::optional<double> dicom_seconds(const std::string& date, const std::string& time) {
  const std::string both = date.substr(0, 8) + time;
  if (time.empty() || both.size() < 10) return std::nullopt;
  const std::size_t start = date.empty() ? 0 : 8;
  const std::size_t point = both.find('.');
  const double fraction = point == std::string::npos ? 0 : digits(both, point + 1, 6) * 1e-6;
  // Months of 31 days: only the order counts.
  const double days = date.empty() ? 0 : (digits(both, 0, 4) * 12 + digits(both, 4, 2)) * 31 + digits(both, 6, 2);
  return ((days * 24 + digits(both, start, 2)) * 60 + digits(both, start + 2, 2)) * 60 + digits(both, start + 4, 2) +
         fraction;
}

std::vector<gdcm::DataSet> dicom_items(const gdcm::DataSet& data, DicomTag tag) {
  std::vector<gdcm::DataSet> items;
  if (!data.FindDataElement(to_gdcm(tag))) return items;
  const gdcm::SmartPointer<gdcm::SequenceOfItems> sequence = data.GetDataElement(to_gdcm(tag)).GetValueAsSQ();
  if (!sequence) return items;
  for (gdcm::SequenceOfItems::SizeType i = 1; i <= sequence->GetNumberOfItems(); ++i)
    items.push_back(sequence->GetItem(i).GetNestedDataSet());
  return items;
}

}  // namespace isostack
