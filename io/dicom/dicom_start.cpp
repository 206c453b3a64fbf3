#include "io/dicom/dicom_start.h"

#include <array>
#include <fstream>
#include <string_view>

namespace isostack {

namespace {

constexpr std::size_t after_magic = 128 + 4;
constexpr std::string_view implicit_little = "1.2.840.10008.1.2", explicit_little = "1.2.840.10008.1.2.1",
                           explicit_big = "1.2.840.10008.1.2.2";

std::uint32_t number(std::string_view bytes, bool big_endian) {
  std::uint32_t result = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    result = result << 8 | static_cast<unsigned char>(bytes[big_endian ? i : bytes.size() - 1 - i]);
  return result;
}

std::string bytes_at(std::istream& stream, std::uintmax_t offset, std::size_t count) {
  std::string bytes(count, '\0');
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(offset));
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

/// True when two elements of group 0008 follow each other here, in growing order.
bool begins_data_set(std::istream& stream, std::uintmax_t offset, std::string_view syntax) {
  const bool big_endian = syntax == explicit_big;
  std::int64_t last = -1;
  for (int i = 0; i < 2; ++i) {
    const std::string bytes = bytes_at(stream, offset, 8);
    if (bytes.size() < 8) return false;
    const std::string_view view = bytes;
    const std::uint32_t element = number(view.substr(2, 2), big_endian);
    if (number(view.substr(0, 2), big_endian) != 0x0008 || element <= last) return false;
    last = element;
    if (syntax == implicit_little) {
      offset += 8 + std::uintmax_t{number(view.substr(4), false)};
      continue;
    }
    // What group 0008 begins with has one of these; sequences come later.
    static constexpr std::string_view short_forms = "AE AS AT CS DA DS DT IS LO LT PN SH ST TM UI UL US";
    const std::string_view vr = view.substr(4, 2);
    if (vr.find(' ') != vr.npos || short_forms.find(vr) == short_forms.npos) return false;
    offset += 8 + number(view.substr(6), big_endian);
  }
  return true;
}

std::optional<std::string> guess_syntax(std::istream& stream, std::uintmax_t offset) {
  for (const std::string_view syntax : {explicit_little, explicit_big, implicit_little})
    if (begins_data_set(stream, offset, syntax)) return std::string(syntax);
  return std::nullopt;
}

std::string element(std::uint16_t number, const char* vr, const std::string& value) {
  const auto word = [](std::size_t value_of_word) {
    return std::string{static_cast<char>(value_of_word & 255), static_cast<char>(value_of_word >> 8)};
  };
  return word(2) + word(number) + vr + word(value.size()) + value;
}

}  // namespace

std::optional<DicomStart> find_dicom_start(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string beginning = bytes_at(stream, 0, after_magic + 2);
  const std::string_view view = beginning;
  const bool has_magic = view.size() >= after_magic && view.substr(128, 4) == "DICM";
  DicomStart start{.offset = has_magic ? after_magic : 0, .guessed_syntax = {}};
  // A file that only lacks the preamble begins with the length of group 0002.
  const bool has_meta_header = has_magic ? view.substr(after_magic) == std::string_view("\2\0", 2)
                                         : view.starts_with(std::string_view("\2\0\0\0UL\4\0", 8));
  if (has_meta_header) return start;
  const std::optional<std::string> guessed = guess_syntax(stream, start.offset);
  if (!guessed && !has_magic) return std::nullopt;
  start.guessed_syntax = guessed.value_or("");
  return start;
}

bool looks_like_dicom(const std::filesystem::path& path) { return find_dicom_start(path).has_value(); }

std::string missing_start(const DicomStart& start) {
  const std::string beginning = std::string(128, '\0') + "DICM";
  if (start.guessed_syntax.empty()) return start.offset == 0 ? beginning : "";
  std::string uid = start.guessed_syntax;
  if (uid.size() % 2 != 0) uid += '\0';
  const std::string syntax = element(0x0010, "UI", uid);
  const std::string length = {static_cast<char>(syntax.size()), '\0', '\0', '\0'};
  return beginning + element(0x0000, "UL", length) + syntax;
}

}  // namespace isostack
