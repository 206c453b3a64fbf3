#include "io/dicom/dicom_text.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace isostack {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// The name iconv knows a character set by; empty when there is none. Of several, joined by escape sequences, the
/// first counts.
std::string iconv_name(const std::string& character_set) {
  std::string first = character_set.substr(0, character_set.find('\\'));
  while (!first.empty() && first.back() == ' ') first.pop_back();
  if (first.starts_with("ISO 2022 IR ")) first = "ISO_IR " + first.substr(12);
  static constexpr std::array<std::pair<std::string_view, const char*>, 15> names = {{{"ISO_IR 100", "ISO-8859-1"},
                                                                                      {"ISO_IR 101", "ISO-8859-2"},
                                                                                      {"ISO_IR 109", "ISO-8859-3"},
                                                                                      {"ISO_IR 110", "ISO-8859-4"},
                                                                                      {"ISO_IR 144", "ISO-8859-5"},
                                                                                      {"ISO_IR 127", "ISO-8859-6"},
                                                                                      {"ISO_IR 126", "ISO-8859-7"},
                                                                                      {"ISO_IR 138", "ISO-8859-8"},
                                                                                      {"ISO_IR 148", "ISO-8859-9"},
                                                                                      {"ISO_IR 203", "ISO-8859-15"},
                                                                                      {"ISO_IR 13", "SHIFT_JIS"},
                                                                                      {"ISO_IR 166", "TIS-620"},
                                                                                      {"ISO_IR 192", "UTF-8"},
                                                                                      {"GB18030", "GB18030"},
                                                                                      {"GBK", "GBK"}}};
  const auto* found = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == first; });
  return found == names.end() ? std::string() : found->second;
}

}  // namespace

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string utf8_from_dicom(const std::string& text, const std::string& character_set) {
  std::string input = text;
  std::erase_if(input, is_control);
  if (is_ascii(input)) return input;
  const std::string name = iconv_name(character_set);
  const iconv_t converter = name.empty() ? reinterpret_cast<iconv_t>(-1) : iconv_open("UTF-8", name.c_str());
  std::string result;
  if (converter == reinterpret_cast<iconv_t>(-1)) {
    std::replace_if(
        input.begin(), input.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
    return input;
  }
  char* in = input.data();
  std::size_t left = input.size();
  while (left > 0) {
    std::array<char, 256> buffer;
    char* out = buffer.data();
    std::size_t room = buffer.size();
    const std::size_t before = left;
    const bool done = iconv(converter, &in, &left, &out, &room) != static_cast<std::size_t>(-1);
    result.append(buffer.data(), out);
    if (!done && left == before && out == buffer.data()) {  // a byte that means nothing
      result += '?';
      ++in, --left;
    }
  }
  iconv_close(converter);
  return result;
}

std::string dicom_from_utf8(const std::string& text, std::size_t most_characters) {
  std::string result;
  std::size_t characters = 0;
  for (const char c : text) {
    if (is_control(c)) continue;
    const bool starts_character = (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    if (starts_character && ++characters > most_characters) break;
    result += c == '\\' ? '/' : c;
  }
  return result;
}

}  // namespace isostack
