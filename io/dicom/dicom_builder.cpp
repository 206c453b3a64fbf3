#include "io/dicom/dicom_builder.h"

#include <fmt/format.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmWriter.h>

#include "io/atomic_file.h"
#include "io/dicom/gdcm_setup.h"
#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// FNV-1a, 64 bits, from the given start.
std::uint64_t hash_of(std::string_view text, std::uint64_t hash) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash ^ (hash >> 29);
}

}  // namespace

void DataSetBuilder::text(const gdcm::Tag& tag, gdcm::VR::VRType vr, std::string value) {
  if (value.size() % 2 != 0) value += vr == gdcm::VR::UI ? '\0' : ' ';
  bytes(tag, vr, value);
}

void DataSetBuilder::number(const gdcm::Tag& tag, std::uint16_t value) {
  bytes(tag, gdcm::VR::US, {reinterpret_cast<const char*>(&value), sizeof(value)});
}

void DataSetBuilder::decimals(const gdcm::Tag& tag, const std::vector<double>& values, int most_digits) {
  std::string joined;
  for (const double value : values) {
    if (!joined.empty()) joined += '\\';
    joined += decimal_string(value, most_digits);
  }
  text(tag, gdcm::VR::DS, std::move(joined));
}

void DataSetBuilder::sequence(const gdcm::Tag& tag, const std::vector<gdcm::DataSet>& items) {
  const gdcm::SmartPointer<gdcm::SequenceOfItems> sequence(new gdcm::SequenceOfItems);
  sequence->SetLengthToUndefined();
  for (const gdcm::DataSet& data : items) {
    gdcm::Item item;
    item.SetVLToUndefined();
    item.SetNestedDataSet(data);
    sequence->AddItem(item);
  }
  gdcm::DataElement element(tag, 0, gdcm::VR::SQ);
  element.SetValue(*sequence);
  element.SetVLToUndefined();
  data_.Replace(element);
}

void DataSetBuilder::bytes(const gdcm::Tag& tag, gdcm::VR::VRType vr, std::string_view value) {
  gdcm::DataElement element(tag, 0, vr);
  element.SetByteValue(value.data(), static_cast<std::uint32_t>(value.size()));
  data_.Replace(element);
}

std::string decimal_string(double value, int most_digits) {
  constexpr std::size_t longest = 16;
  for (int digits = most_digits; digits >= 0; --digits) {
    std::string text = fmt::format("{:.{}f}", value, digits);
    if (digits > 0) text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    if (text == "-0") text = "0";
    if (text.size() <= longest) return text;
  }
  return fmt::format("{:.8g}", value);
}

std::string uid_from(std::string_view text) {
  const std::uint64_t high = hash_of(text, 0xcbf29ce484222325);
  return uid_from(high, hash_of(text, high ^ 0x9e3779b97f4a7c15));
}

std::string uid_from(std::uint64_t high, std::uint64_t low) {
  high = (high & ~0xf000ull) | 0x8000;                    // version 8: made by other means
  low = (low & 0x3fffffffffffffff) | 0x8000000000000000;  // variant of RFC 9562
  return fmt::format("2.25.{}", (static_cast<unsigned __int128>(high) << 64) | low);
}

void write_dicom_file(const gdcm::DataSet& data, const std::filesystem::path& path,
                      gdcm::TransferSyntax::TSType encoding) {
  set_up_gdcm();
  AtomicFile file(path);
  gdcm::Writer writer;
  writer.SetFileName(file.temporary().c_str());
  writer.GetFile().SetDataSet(data);
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(encoding);
  if (!writer.Write())
    throw InputError(path.string(), "it cannot be written to the end", "check that the disk has free space");
  file.commit();
}

}  // namespace isostack
