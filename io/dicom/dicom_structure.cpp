#include "io/dicom/dicom_structure.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "io/dicom/inflate.h"

namespace isostack {

namespace {

constexpr std::uint32_t undefined_length = 0xffffffff;
constexpr std::uint32_t item = 0xfffee000, item_end = 0xfffee00d, sequence_end = 0xfffee0dd;
constexpr std::uint32_t meta_length = 0x00020000, transfer_syntax = 0x00020010, pixel_data = 0x7fe00010;
constexpr int deepest_nesting = 64;

/// How elements are written (DICOM PS3.5, section 7.1).
struct Encoding {
  bool explicit_vr = true;
  bool big_endian = false;
};

struct Damaged {};  // an element is not all there, or is not one

struct Element {
  std::uint32_t tag = 0;
  std::uint32_t length = 0;
  std::string vr;
};

class Walk {
 public:
  Walk(std::istream& stream, std::uintmax_t size, std::uintmax_t start) : stream_(stream), size_(size) { go_to(start); }

  /// Everything from here on.
  std::string rest() { return text_with_nulls(static_cast<std::size_t>(size_ - position_)); }

  /// Returns the transfer syntax's UID; ends before the first element of another group, which must
  /// be where the group's length says.
  std::string meta_information() {
    std::string uid;
    std::uintmax_t announced_end = 0;
    if (next_group() != 2) throw Damaged();  // neither a meta header nor a data set that can be told
    while (position_ < size_ && next_group() == 2) {
      const Element element = next({});
      if (element.vr == "SQ" || (element.tag == meta_length && element.length != 4)) throw Damaged();
      if (element.tag == transfer_syntax && element.length <= 64) {
        uid = text(element.length);
      } else if (element.tag == meta_length) {
        const std::uint32_t length = number(4, false);
        announced_end = position_ + length;
      } else {
        skip(element.length);
      }
    }
    if (announced_end != 0 && announced_end != position_) throw Damaged();
    return uid;
  }

  /// Walks to the end of the pixel data or of the file.
  void data_set(const Encoding& encoding, DicomStructure& structure) {
    if (position_ == size_) throw Damaged();  // GDCM cannot bear an empty data set either
    while (position_ < size_) {
      const Element element = next(encoding);
      if (element.tag >> 16 == 0xfffe) throw Damaged();  // as in members()
      const std::uintmax_t start = position_;
      value(element, encoding, 0);
      if (element.tag != pixel_data) continue;
      structure.has_pixels = true;
      if (element.length == undefined_length) return;
      structure.pixels_are_words = element.vr == "OW";
      structure.pixel_offset = start;
      structure.pixel_bytes = element.length;
      return;
    }
  }

 private:
  void go_to(std::uintmax_t position) {
    if (position > size_) throw Damaged();
    position_ = position;
    stream_.seekg(static_cast<std::streamoff>(position));
  }
  void skip(std::uintmax_t bytes) {
    if (bytes > size_ - position_) throw Damaged();
    constexpr std::uintmax_t cheaper_to_read = 4096;  // than to seek, which empties the buffer
    position_ += bytes;
    if (bytes <= cheaper_to_read)
      stream_.ignore(static_cast<std::streamsize>(bytes));
    else
      stream_.seekg(static_cast<std::streamoff>(position_));
  }
  std::string text_with_nulls(std::size_t bytes) {
    std::string result(bytes, '\0');
    position_ += bytes;
    if (!stream_.read(result.data(), static_cast<std::streamsize>(bytes))) throw Damaged();
    return result;
  }
  std::string text(std::size_t bytes) {
    const std::string padded = text_with_nulls(bytes);
    return padded.substr(0, padded.find('\0'));
  }
  std::uint32_t number(int bytes, bool big_endian) {
    std::array<unsigned char, 4> raw{};
    position_ += static_cast<unsigned>(bytes);
    if (!stream_.read(reinterpret_cast<char*>(raw.data()), bytes)) throw Damaged();
    std::uint32_t result = 0;
    for (int i = 0; i < bytes; ++i)
      result = result << 8 | raw[static_cast<std::size_t>(big_endian ? i : bytes - 1 - i)];
    return result;
  }

  /// The group number ahead, in little endian.
  std::uint32_t next_group() {
    const std::uintmax_t start = position_;
    const std::uint32_t group = number(2, false);
    go_to(start);
    return group;
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
    constexpr std::string_view short_forms = "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";
    constexpr std::string_view long_forms = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
    const bool is_long = long_forms.find(element.vr) != std::string_view::npos;
    const bool is_known = is_long || short_forms.find(element.vr) != std::string_view::npos;
    if (element.vr.size() != 2 || element.vr.find(' ') != std::string::npos || !is_known) throw Damaged();
    if (!is_long) {
      element.length = number(2, encoding.big_endian);
    } else {
      skip(2);
      element.length = number(4, encoding.big_endian);
    }
    return element;
  }

  /// Implicit VR does not tell sequences of known length; GDCM looks into them when asked to.
  bool is_implicit_sequence(const Element& element, const Encoding& encoding) {
    const bool is_private = (element.tag >> 16) % 2 != 0;
    if (encoding.explicit_vr || is_private || element.length < 8 || element.length > size_ - position_) return false;
    const std::uintmax_t start = position_;
    const std::uint32_t group = number(2, encoding.big_endian);
    const bool is_sequence = (group << 16 | number(2, encoding.big_endian)) == item;
    go_to(start);
    return is_sequence;
  }

  /// Only sequences, and in fragments pixels, may leave their length open; GDCM ends the program on others.
  static bool is_possible(const Element& element) {
    if (element.tag == pixel_data && element.vr == "SQ") return false;
    if (element.length != undefined_length) return true;
    return element.tag == pixel_data ? element.vr == "OB" || element.vr == "OW"
                                     : element.vr == "SQ" || element.vr == "UN";
  }

  /// Delimiters have no value; GDCM makes room for as much as one claims.
  void delimiter(const Element& element) const {
    if (element.length > size_ - position_) throw Damaged();
  }

  void value(const Element& element, const Encoding& encoding, int depth) {
    if (encoding.explicit_vr && !is_possible(element)) throw Damaged();
    const bool is_undefined = element.length == undefined_length;
    if (!is_undefined && element.vr != "SQ" && !is_implicit_sequence(element, encoding)) return skip(element.length);
    if (depth > deepest_nesting) throw Damaged();
    const Encoding inner = {encoding.explicit_vr && element.vr != "UN", encoding.big_endian};
    const std::uintmax_t end = position_ + element.length;
    while (is_undefined || position_ < end) {
      const Element part = next(inner);
      if (is_undefined && part.tag == sequence_end) return delimiter(part);
      if (part.tag != item) throw Damaged();
      if (element.tag == pixel_data)
        skip(part.length);  // a fragment of compressed pixels
      else
        members(part, inner, depth + 1);
    }
    if (position_ != end) throw Damaged();
  }

  void members(const Element& part, const Encoding& encoding, int depth) {
    const bool is_undefined = part.length == undefined_length;
    const std::uintmax_t end = position_ + part.length;
    while (is_undefined || position_ < end) {
      const Element member = next(encoding);
      if (is_undefined && member.tag == item_end) return delimiter(member);
      if (member.tag >> 16 == 0xfffe) throw Damaged();  // GDCM ends the program on an item outside of a sequence
      value(member, encoding, depth);
    }
    if (position_ != end) throw Damaged();
  }

  std::istream& stream_;
  std::uintmax_t size_, position_ = 0;
};

/// The inflated data set is walked; it has no places in the file.
void walk_deflated(const std::string& deflated, DicomStructure& structure) {
  constexpr std::size_t most_bytes = std::size_t{1} << 31;
  const std::optional<std::string> data = inflate_raw(deflated, most_bytes);
  if (!data) throw Damaged();
  std::istringstream stream(*data);
  Walk(stream, data->size(), 0).data_set({}, structure);
  structure.is_deflated = true;
  structure.pixel_offset = structure.pixel_bytes = 0;
}

}  // namespace

DicomStructure walk_dicom(const std::filesystem::path& path, const DicomStart& start) {
  DicomStructure structure;
  try {
    std::ifstream stream(path, std::ios::binary);
    Walk walk(stream, std::filesystem::file_size(path), start.offset);
    const std::string syntax = start.guessed_syntax.empty() ? walk.meta_information() : start.guessed_syntax;
    if (syntax == "1.2.840.10008.1.2.1.99")
      walk_deflated(walk.rest(), structure);
    else
      walk.data_set({.explicit_vr = syntax != "1.2.840.10008.1.2", .big_endian = syntax == "1.2.840.10008.1.2.2"},
                    structure);
  } catch (const Damaged&) {
    structure.is_whole = false;
  }
  return structure;
}

}  // namespace isostack
