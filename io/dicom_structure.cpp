#include "io/dicom_structure.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>

namespace isostack {

namespace {

constexpr std::uint32_t undefined_length = 0xffffffff;
constexpr std::uint32_t item = 0xfffee000, item_end = 0xfffee00d, sequence_end = 0xfffee0dd;
constexpr std::uint32_t transfer_syntax = 0x00020010, pixel_data = 0x7fe00010;
constexpr int deepest_nesting = 64;

/// How elements are written (DICOM PS3.5, section 7.1).
struct Encoding {
  bool explicit_vr = true;
  bool big_endian = false;
};

struct CutOff {};       // an element or its value is not all there
struct UnknownForm {};  // not an element this walk understands

struct Element {
  std::uint32_t tag = 0;
  std::uint32_t length = 0;
  std::string vr;
};

class Walk {
 public:
  explicit Walk(const std::filesystem::path& path)
      : stream_(path, std::ios::binary), size_(std::filesystem::file_size(path)) {
    go_to(128 + 4);
  }

  /// Returns the transfer syntax's UID; ends before the first element of another group.
  std::string meta_information() {
    std::string uid;
    while (position_ < size_) {
      const std::uintmax_t start = position_;
      const Element element = next({});
      if (element.tag >> 16 != 2) {
        go_to(start);
        break;
      }
      if (element.tag == transfer_syntax && element.length <= 64)
        uid = text(element.length);
      else
        skip(element.length);
    }
    return uid;
  }

  /// Walks to the end of the pixel data or of the file.
  bool data_set(const Encoding& encoding) {
    if (position_ == size_) throw CutOff();  // GDCM cannot bear an empty data set either
    while (position_ < size_) {
      const Element element = next(encoding);
      value(element, encoding, 0);
      if (element.tag == pixel_data) return true;
    }
    return false;
  }

 private:
  void go_to(std::uintmax_t position) {
    if (position > size_) throw CutOff();
    position_ = position;
    stream_.seekg(static_cast<std::streamoff>(position));
  }
  void skip(std::uintmax_t bytes) {
    if (bytes > size_ - position_) throw CutOff();
    constexpr std::uintmax_t cheaper_to_read = 4096;  // than to seek, which empties the buffer
    position_ += bytes;
    if (bytes <= cheaper_to_read)
      stream_.ignore(static_cast<std::streamsize>(bytes));
    else
      stream_.seekg(static_cast<std::streamoff>(position_));
  }
  std::string text(std::size_t bytes) {
    std::string result(bytes, '\0');
    position_ += bytes;
    if (!stream_.read(result.data(), static_cast<std::streamsize>(bytes))) throw CutOff();
    return result.c_str();
  }
  std::uint32_t number(int bytes, bool big_endian) {
    std::array<unsigned char, 4> raw{};
    position_ += static_cast<unsigned>(bytes);
    if (!stream_.read(reinterpret_cast<char*>(raw.data()), bytes)) throw CutOff();
    std::uint32_t result = 0;
    for (int i = 0; i < bytes; ++i)
      result = result << 8 | raw[static_cast<std::size_t>(big_endian ? i : bytes - 1 - i)];
    return result;
  }

  Element next(const Encoding& encoding) {
    Element element;
    const std::uint32_t group = number(2, encoding.big_endian);
    element.tag = group << 16 | number(2, encoding.big_endian);
    if (!encoding.explicit_vr || group == 0xfffe) {
      element.length = number(4, encoding.big_endian);
      return element;
    }
    element.vr = text(2);
    if (element.vr.size() != 2 || element.vr.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") != std::string::npos)
      throw UnknownForm();
    constexpr std::string_view long_forms = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
    if (long_forms.find(element.vr) == std::string_view::npos) {
      element.length = number(2, encoding.big_endian);
    } else {
      skip(2);
      element.length = number(4, encoding.big_endian);
    }
    return element;
  }

  void value(const Element& element, const Encoding& encoding, int depth) {
    if (element.length != undefined_length) return skip(element.length);
    if (depth > deepest_nesting) throw UnknownForm();
    const Encoding inner = {encoding.explicit_vr && element.vr != "UN", encoding.big_endian};
    for (Element part = next(inner); part.tag != sequence_end; part = next(inner)) {
      if (part.tag != item) throw UnknownForm();
      if (part.length != undefined_length) {
        skip(part.length);
        continue;
      }
      for (Element member = next(inner); member.tag != item_end; member = next(inner)) value(member, inner, depth + 1);
    }
  }

  std::ifstream stream_;
  std::uintmax_t size_, position_ = 0;
};

}  // namespace

DicomStructure walk_dicom(const std::filesystem::path& path) {
  DicomStructure structure;
  try {
    Walk walk(path);
    const std::string syntax = walk.meta_information();
    if (syntax == "1.2.840.10008.1.2.1.99") {  // deflated
      structure.has_pixels = true;
      return structure;
    }
    structure.has_pixels =
        walk.data_set({.explicit_vr = syntax != "1.2.840.10008.1.2", .big_endian = syntax == "1.2.840.10008.1.2.2"});
  } catch (const CutOff&) {
    structure.is_whole = false;
  } catch (const UnknownForm&) {
    structure.has_pixels = true;  // unknown; GDCM will tell
  }
  return structure;
}

}  // namespace isostack
