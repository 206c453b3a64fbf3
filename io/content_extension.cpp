#include "io/content_extension.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace isostack {

namespace {

struct Mark {
  std::string_view bytes;
  std::size_t at;
  std::string_view extension;
};

using namespace std::string_view_literals;

/// In this order: what is certain first.
constexpr std::array marks = {
    Mark{"DICM"sv, 128, ".dcm"},      Mark{"n+1\0"sv, 344, ".nii"},      Mark{"n+2\0"sv, 4, ".nii"},
    Mark{"\x1f\x8b"sv, 0, ".nii.gz"}, Mark{"NRRD"sv, 0, ".nrrd"},        Mark{"ObjectType"sv, 0, ".mha"},
    Mark{"NDims"sv, 0, ".mha"},       Mark{"ply\n"sv, 0, ".ply"},        Mark{"ply\r"sv, 0, ".ply"},
    Mark{"solid"sv, 0, ".stl"},       Mark{"<?xml"sv, 0, ".vtp"},        Mark{"<VTKFile"sv, 0, ".vtp"},
    Mark{"\x89PNG\r\n"sv, 0, ".png"}, Mark{"\xff\xd8\xff"sv, 0, ".jpg"}, Mark{"II*\0"sv, 0, ".tif"},
    Mark{"MM\0*"sv, 0, ".tif"},
};

/// Told by its size only: a free header of 80 bytes, a count, and 50 bytes a triangle.
bool is_binary_stl(std::string_view start, std::uintmax_t size_bytes) {
  if (start.size() < 84) return false;
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, start.data() + 80, sizeof triangles);  // little endian, as all machines of this program
  return size_bytes == 84 + std::uintmax_t{50} * triangles;
}

/// The first word of the first line that is no comment.
std::string_view first_word(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
    if (!text.starts_with('#')) return text.substr(0, text.find_first_of(blank));
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
}

}  // namespace

std::string_view content_extension(std::string_view start, std::uintmax_t size_bytes) {
  if (is_binary_stl(start, size_bytes)) return ".stl";  // before the marks: its free header may begin with "solid"
  for (const Mark& mark : marks)
    if (start.size() >= mark.at + mark.bytes.size() && start.substr(mark.at, mark.bytes.size()) == mark.bytes)
      return mark.extension;
  const std::string_view word = first_word(start);
  if (word.starts_with('{')) return ".json";
  if (word.starts_with("CSLC")) return ".csl";
  for (const std::string_view obj : {"v", "vn", "vt", "o", "g", "mtllib"})
    if (word == obj) return ".obj";
  return "";
}

}  // namespace isostack
