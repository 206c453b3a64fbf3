#include "io/volumes/nrrd_segments.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <vector>

namespace isostack {

namespace {

/// The value of a "key:=value" line; NRRD escapes line breaks and backslashes in it.
std::string key_value(const TextHeader& fields, const std::string& key) {
  const std::string stored = fields.text(key);
  std::string text;
  for (std::size_t i = stored.starts_with('=') ? 1 : 0; i < stored.size(); ++i) {
    const bool escaped = stored[i] == '\\' && i + 1 < stored.size();
    if (escaped) ++i;
    text += escaped && stored[i] == 'n' ? ' ' : stored[i];
  }
  return text;
}

/// The numbers n for which there is any field "segment<n>_...".
std::set<int> segment_numbers(const TextHeader& fields) {
  constexpr std::string_view prefix = "segment";
  std::set<int> numbers;
  for (auto field = fields.values.lower_bound(std::string(prefix)); field != fields.values.end(); ++field) {
    const std::string& key = field->first;
    if (!key.starts_with(prefix)) break;
    int number = 0;
    const auto [end, error] = std::from_chars(key.data() + prefix.size(), key.data() + key.size(), number);
    if (error == std::errc() && end != key.data() + key.size() && *end == '_') numbers.insert(number);
  }
  return numbers;
}

std::optional<Color> color_in(const std::string& text) {
  const std::vector<double> channels = parse_numbers(text);
  if (channels.size() != 3) return std::nullopt;
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(channels[i])) return std::nullopt;
    bytes[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(channels[i], 0.0, 1.0)));
  }
  return Color{bytes[0], bytes[1], bytes[2]};
}

/// A whole number of the field, `otherwise` when it is missing, -1 when it is none or does not fit into 16 bits.
int whole_number(const TextHeader& fields, const std::string& key, int otherwise) {
  const std::vector<double> numbers = parse_numbers(key_value(fields, key));
  if (numbers.empty()) return otherwise;
  return numbers.front() >= 0 && numbers.front() <= 65535 ? static_cast<int>(numbers.front()) : -1;
}

struct Extent {
  Eigen::Vector3i lower = Eigen::Vector3i::Zero(), upper = Eigen::Vector3i::Constant(-1);
};

std::vector<Extent> extents_of(const LabelMap& map, const std::vector<Segment>& segments) {
  std::vector<Extent> extents(segments.size());
  for (std::size_t layer = 0; layer < map.layers.size(); ++layer) {
    std::vector<Extent> of_value(65536);
    const LabelVolume& labels = map.layers[layer];
    Eigen::Vector3i at;
    for (at.z() = 0; at.z() < labels.grid.size.z(); ++at.z())
      for (at.y() = 0; at.y() < labels.grid.size.y(); ++at.y())
        for (at.x() = 0; at.x() < labels.grid.size.x(); ++at.x()) {
          const std::uint16_t value = labels.at(at.x(), at.y(), at.z());
          if (value == 0) continue;
          Extent& extent = of_value[value];
          const bool first = extent.upper.x() < 0;
          extent.lower = first ? at : extent.lower.cwiseMin(at).eval();
          extent.upper = extent.upper.cwiseMax(at).eval();
        }
    for (std::size_t s = 0; s < segments.size(); ++s)
      if (segments[s].layer == layer) extents[s] = of_value[segments[s].value];
  }
  return extents;
}

/// As NRRD wants it in a "key:=value" line, on one line.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\\' ? "\\\\" : c == '\n' ? "\\n" : c == '\r' ? " " : std::string(1, c);
  return result;
}

}  // namespace

void add_nrrd_segments(const TextHeader& fields, LabelMap& map) {
  for (const int number : segment_numbers(fields)) {
    const std::string prefix = fmt::format("segment{}_", number);
    const int layer = whole_number(fields, prefix + "layer", map.layers.size() > 1 ? number : 0);
    const int value = whole_number(fields, prefix + "labelvalue", 1);
    Segment segment{.name = key_value(fields, prefix + "name")};
    if (segment.name.empty()) segment.name = key_value(fields, prefix + "id");
    if (segment.name.empty()) segment.name = std::to_string(number + 1);
    if (layer < 0 || static_cast<std::size_t>(layer) >= map.layers.size() || value < 1) {
      map.warnings.push_back("segment left out: '" + segment.name + "' is in a layer or has a value that cannot be");
      continue;
    }
    segment.layer = static_cast<std::size_t>(layer);
    segment.value = static_cast<std::uint16_t>(value);
    segment.color = color_in(key_value(fields, prefix + "color"));
    map.segments.push_back(std::move(segment));
  }
}

std::string nrrd_segment_lines(const LabelMap& map) {
  const std::vector<Segment> segments = all_segments(map);
  const std::vector<Extent> extents = extents_of(map, segments);
  std::string lines;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Segment& segment = segments[s];
    const Eigen::Vector3i &a = extents[s].lower, &b = extents[s].upper;
    const std::string prefix = fmt::format("Segment{}_", s);
    if (segment.color)
      lines += fmt::format("{}Color:={:.6f} {:.6f} {:.6f}\n", prefix, segment.color->red / 255.0,
                           segment.color->green / 255.0, segment.color->blue / 255.0);
    lines += fmt::format("{}Extent:={} {} {} {} {} {}\n", prefix, a.x(), b.x(), a.y(), b.y(), a.z(), b.z());
    lines += fmt::format("{0}ID:=Segment_{1}\n{0}LabelValue:={2}\n{0}Layer:={3}\n{0}Name:={4}\n", prefix, s + 1,
                         segment.value, segment.layer, escaped(segment.name));
    lines += prefix + "Tags:=Segmentation.Status:completed|\n";
  }
  if (segments.empty()) return lines;
  return lines +
         "Segmentation_ContainedRepresentationNames:=Binary labelmap|\n"
         "Segmentation_MasterRepresentation:=Binary labelmap\n"
         "Segmentation_ReferenceImageExtentOffset:=0 0 0\n";
}

}  // namespace isostack
