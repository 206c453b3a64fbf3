#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "tests/io/io_support.h"

namespace isostack::testing {

inline std::string little(std::uint64_t value, int bytes) {
  std::string result;
  for (int i = 0; i < bytes; ++i) result += static_cast<char>(value >> (8 * i) & 0xff);
  return result;
}

/// A DICOM data set by tag (group << 16 | element), to be written in any of the plain encodings: good files and
/// bad ones, which the project's own writer would refuse to make.
class DicomBytes {
 public:
  struct Encoding {
    bool explicit_vr = true;
    bool big_endian = false;
  };

  DicomBytes& text(std::uint32_t tag, const std::string& vr, std::string value) {
    if (value.size() % 2 != 0) value += vr == "UI" ? '\0' : ' ';
    return set(tag, vr, value, 1);
  }
  DicomBytes& us(std::uint32_t tag, std::uint64_t value) { return set(tag, "US", little(value, 2), 2); }
  DicomBytes& ul(std::uint32_t tag, std::uint64_t value) { return set(tag, "UL", little(value, 4), 4); }
  DicomBytes& fd(std::uint32_t tag, double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return set(tag, "FD", little(bits, 8), 8);
  }
  /// `word`: bytes that are turned round together in big endian.
  DicomBytes& set(std::uint32_t tag, const std::string& vr, const std::string& value, int word) {
    elements_[tag] = {vr, value, word, {}};
    return *this;
  }
  DicomBytes& sequence(std::uint32_t tag, const std::vector<DicomBytes>& items) {
    elements_[tag] = {"SQ", {}, 1, items};
    return *this;
  }
  DicomBytes& without(std::uint32_t tag) {
    elements_.erase(tag);
    return *this;
  }

  std::string encoded(Encoding e) const {
    std::string bytes;
    for (const auto& [tag, element] : elements_) {
      std::string value = element.value;
      for (const DicomBytes& item : element.items) {
        const std::string members = item.encoded(e);
        value += number(0xfffe, 2, e) + number(0xe000, 2, e) + number(members.size(), 4, e) + members;
      }
      if (e.big_endian)
        for (std::size_t i = 0; i + element.word <= value.size(); i += element.word)
          std::reverse(value.begin() + static_cast<long>(i), value.begin() + static_cast<long>(i + element.word));
      bytes += number(tag >> 16, 2, e) + number(tag & 0xffff, 2, e);
      const bool is_long = element.vr == "SQ" || element.vr == "OW" || element.vr == "OB" || element.vr == "UN";
      if (!e.explicit_vr)
        bytes += number(value.size(), 4, e);
      else if (is_long)
        bytes += element.vr + std::string(2, '\0') + number(value.size(), 4, e);
      else
        bytes += element.vr + number(value.size(), 2, e);
      bytes += value;
    }
    return bytes;
  }

  /// A whole file; the transfer syntax follows from the encoding.
  std::string file(Encoding e = {true, false}) const {
    const std::string syntax = !e.explicit_vr ? "1.2.840.10008.1.2"
                               : e.big_endian ? "1.2.840.10008.1.2.2"
                                              : "1.2.840.10008.1.2.1";
    DicomBytes meta;
    meta.text(0x00020010, "UI", syntax);
    const std::string bytes = meta.encoded({});
    DicomBytes length;
    length.ul(0x00020000, bytes.size());
    return std::string(128, '\0') + "DICM" + length.encoded({}) + bytes + encoded(e);
  }

 private:
  struct Element {
    std::string vr, value;
    int word = 1;
    std::vector<DicomBytes> items;
  };
  static std::string number(std::uint64_t value, int bytes, Encoding e) {
    std::string result = little(value, bytes);
    if (e.big_endian) std::reverse(result.begin(), result.end());
    return result;
  }
  std::map<std::uint32_t, Element> elements_;
};

inline std::string decimals(const std::vector<double>& values) {
  std::ostringstream text;
  for (std::size_t i = 0; i < values.size(); ++i) text << (i ? "\\" : "") << values[i];
  return text.str();
}

/// 16-bit pixels of `count` values: first, first + 1, ...
inline std::string counting_pixels(int count, int first = 0) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += little(static_cast<std::uint64_t>(first + i), 2);
  return bytes;
}

constexpr int test_columns = 5, test_rows = 4, test_pixels = test_columns * test_rows;

/// An MR picture of 5 x 4 unsigned 16-bit pixels of 2 x 3 mm that count from 0, without a place.
inline DicomBytes picture_without_place(const std::string& instance_uid) {
  DicomBytes data;
  data.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.4").text(0x00080018, "UI", instance_uid);
  data.text(0x00080060, "CS", "MR").text(0x0020000d, "UI", "1.2.3").text(0x0020000e, "UI", "1.2.3.4");
  data.us(0x00280002, 1).text(0x00280004, "CS", "MONOCHROME2").us(0x00280010, test_rows).us(0x00280011, test_columns);
  data.us(0x00280100, 16).us(0x00280101, 16).us(0x00280102, 15).us(0x00280103, 0);
  data.set(0x7fe00010, "OW", counting_pixels(test_pixels), 2);
  return data;
}

/// The same in an axial plane at this height.
inline DicomBytes picture_at(double z_mm, const std::string& instance_uid) {
  DicomBytes data = picture_without_place(instance_uid);
  data.text(0x00200032, "DS", decimals({-10, -20, z_mm})).text(0x00200037, "DS", "1\\0\\0\\0\\1\\0");
  data.text(0x00280030, "DS", "3\\2");  // rows are 3 mm apart, columns 2
  return data;
}

/// A picture whose pixels are one RLE fragment of four bytes; its end claims a value of `claimed` bytes.
inline std::string fragments_that_end_with(std::uint64_t claimed) {
  std::string bytes = picture_without_place("1.2.3").us(0x00280010, 1).us(0x00280011, 4).without(0x7fe00010).file();
  const std::string plain = "1.2.840.10008.1.2.1", rle = "1.2.840.10008.1.2.5";
  bytes.replace(bytes.find(plain), plain.size(), rle);
  const std::string item("\xfe\xff\x00\xe0", 4), end("\xfe\xff\xdd\xe0", 4);
  bytes += std::string("\xe0\x7f\x10\x00OB\x00\x00\xff\xff\xff\xff", 12);
  return bytes + item + little(0, 4) + item + little(4, 4) + "\3abc" + end + little(claimed, 4);
}

}  // namespace isostack::testing
