#pragma once

#include <gdcmDataSet.h>
#include <gdcmTransferSyntax.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isostack {

/// A DICOM data set under construction.
class DataSetBuilder {
 public:
  DataSetBuilder() = default;
  explicit DataSetBuilder(const gdcm::DataSet& begun) : data_(begun) {}

  void text(const gdcm::Tag& tag, gdcm::VR::VRType vr, std::string value);  ///< padded as the VR asks
  void number(const gdcm::Tag& tag, std::uint16_t value);                   ///< US
  void decimals(const gdcm::Tag& tag, const std::vector<double>& values, int most_digits = 10);
  void sequence(const gdcm::Tag& tag, const std::vector<gdcm::DataSet>& items);
  void bytes(const gdcm::Tag& tag, gdcm::VR::VRType vr, std::string_view value);
  const gdcm::DataSet& result() const { return data_; }

 private:
  gdcm::DataSet data_;
};

/// DS of one number: at most 16 characters, at most `most_digits` after the point, no useless zeros.
std::string decimal_string(double value, int most_digits = 10);

/// A UID under "2.25." that follows from the text (DICOM PS3.5, B.2), or from 128 bits.
std::string uid_from(std::string_view text);
std::string uid_from(std::uint64_t high, std::uint64_t low);

/// Writes an uncompressed file, which appears whole or not at all; SOP class and instance are those of the data set.
/// Texts longer than 65534 bytes need the encoding without explicit VRs. Throws InputError naming the file when it
/// cannot be written.
void write_dicom_file(const gdcm::DataSet& data, const std::filesystem::path& path,
                      gdcm::TransferSyntax::TSType encoding = gdcm::TransferSyntax::ExplicitVRLittleEndian);

}  // namespace isostack
