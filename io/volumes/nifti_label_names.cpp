#include "io/volumes/nifti_label_names.h"

#include <fmt/format.h>
#include <vtkObjectFactory.h>
#include <vtkXMLParser.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "io/vtk_errors.h"

namespace isostack {

namespace {

constexpr std::int32_t comment_code = 0, caret_code = 30;
constexpr std::uintmax_t longest_extensions = 16 << 20;

/// Collects the <Label> elements.
class LabelTableParser : public vtkXMLParser {
 public:
  static LabelTableParser* New();
  vtkTypeMacro(LabelTableParser, vtkXMLParser)

      std::vector<Segment> segments;

 protected:
  LabelTableParser() = default;

  // NOLINTBEGIN(readability-identifier-naming): VTK calls them so.
  void StartElement(const char* name, const char** attributes) override {
    in_label_ = std::strcmp(name, "Label") == 0;
    if (!in_label_) return;
    current_ = {};
    int key = 0;
    std::array<double, 3> channels{-1, -1, -1};
    for (; attributes[0] && attributes[1]; attributes += 2) {
      const std::string attribute = attributes[0], value = attributes[1];
      if (attribute == "Key") std::from_chars(value.data(), value.data() + value.size(), key);
      if (attribute == "Red") channels[0] = channel(value);
      if (attribute == "Green") channels[1] = channel(value);
      if (attribute == "Blue") channels[2] = channel(value);
    }
    is_usable_ = key > 0 && key <= 65535;
    if (is_usable_) current_.value = static_cast<std::uint16_t>(key);
    if (std::all_of(channels.begin(), channels.end(), [](double c) { return c >= 0; }))
      current_.color = Color{as_byte(channels[0]), as_byte(channels[1]), as_byte(channels[2])};
  }
  void CharacterDataHandler(const char* text, int length) override {
    if (in_label_) current_.name.append(text, static_cast<std::size_t>(length));
  }
  void EndElement(const char* name) override {
    if (std::strcmp(name, "Label") == 0 && is_usable_ && !current_.name.empty()) segments.push_back(current_);
    in_label_ = is_usable_ = false;
  }
  // NOLINTEND(readability-identifier-naming)

 private:
  static double channel(const std::string& text) {
    double value = -1;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return std::isfinite(value) ? value : -1;
  }
  static std::uint8_t as_byte(double channel) {
    return static_cast<std::uint8_t>(std::lround(255 * std::min(channel, 1.0)));
  }

  Segment current_;
  bool in_label_ = false, is_usable_ = false;
};

vtkStandardNewMacro(LabelTableParser)

    std::vector<Segment> parse_table(const std::string& xml) {
  const vtkNew<LabelTableParser> parser;
  const vtkNew<VtkErrors> errors = capture_errors(*parser);
  const bool parsed = parser->Parse(xml.c_str(), static_cast<unsigned>(xml.size())) != 0;
  return parsed ? parser->segments : std::vector<Segment>();
}

/// The bytes from the end of the header to the first voxel.
std::string extension_bytes(const NiftiHeader& header) {
  const std::uintmax_t begin = header.extensions_begin, end = header.voxels.offset_bytes;
  if (end <= begin + 12 || end - begin > longest_extensions) return {};
  std::string bytes(end - begin, '\0');
  gzFile file = gzopen(header.voxels.path.c_str(), "rb");  // reads plain files as well
  const bool read = file && gzseek(file, static_cast<z_off_t>(begin), SEEK_SET) >= 0 &&
                    gzread(file, bytes.data(), static_cast<unsigned>(bytes.size())) == static_cast<int>(bytes.size());
  if (file) gzclose(file);
  return read ? bytes : std::string();
}

std::int32_t number_at(const std::string& bytes, std::size_t at, bool swapped) {
  std::array<char, 4> raw;
  std::memcpy(raw.data(), bytes.data() + at, raw.size());
  if (swapped) std::reverse(raw.begin(), raw.end());
  std::int32_t number = 0;
  std::memcpy(&number, raw.data(), raw.size());
  return number;
}

std::string as_xml(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      default:
        xml += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return xml;
}

std::string table_of(const std::vector<Segment>& segments) {
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<CaretExtension><VolumeInformation Index=\"0\"><LabelTable>\n";
  for (const Segment& segment : segments) {
    xml += fmt::format("<Label Key=\"{}\"", segment.value);
    if (segment.color)
      xml += fmt::format(" Red=\"{:.6f}\" Green=\"{:.6f}\" Blue=\"{:.6f}\" Alpha=\"1\"", segment.color->red / 255.0,
                         segment.color->green / 255.0, segment.color->blue / 255.0);
    xml += fmt::format(">{}</Label>\n", as_xml(segment.name));
  }
  return xml + "</LabelTable><VolumeType>Label</VolumeType></VolumeInformation></CaretExtension>\n";
}

}  // namespace

std::vector<Segment> read_nifti_label_names(const NiftiHeader& header) {
  const std::string bytes = extension_bytes(header);
  if (bytes.size() < 4 || bytes[0] == 0) return {};
  for (std::size_t at = 4; at + 8 <= bytes.size();) {
    const std::int32_t size = number_at(bytes, at, header.voxels.swapped);
    const std::int32_t code = number_at(bytes, at + 4, header.voxels.swapped);
    if (size < 8 || static_cast<std::size_t>(size) > bytes.size() - at) break;
    std::string content = bytes.substr(at + 8, static_cast<std::size_t>(size) - 8);
    content.resize(content.find_last_not_of(std::string_view("\0 \n\r", 4)) + 1);  // padding
    at += static_cast<std::size_t>(size);
    if ((code != comment_code && code != caret_code) || content.find("<LabelTable") == std::string::npos) continue;
    const std::size_t begin = content.find('<');
    if (std::vector<Segment> segments = parse_table(content.substr(begin)); !segments.empty()) return segments;
  }
  return {};
}

std::string nifti_label_extension(const std::vector<Segment>& segments) {
  if (segments.empty()) return std::string(4, '\0');
  const std::string xml = table_of(segments);
  const std::size_t size = (8 + xml.size() + 15) / 16 * 16;
  std::string bytes("\1\0\0\0", 4);
  for (const auto number : {static_cast<std::int32_t>(size), caret_code})
    bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
  bytes += xml;
  bytes.resize(4 + size, '\0');
  return bytes;
}

}  // namespace isostack
