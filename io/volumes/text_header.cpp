#include "io/volumes/text_header.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

constexpr std::uintmax_t longest_header = 1024 * 1024;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace

std::string TextHeader::text(const std::string& key) const {
  const auto found = values.find(key);
  return found == values.end() ? "" : found->second;
}

std::string TextHeader::lower(const std::string& key) const { return in_lower_case(text(key)); }

std::vector<double> TextHeader::numbers(const std::string& key) const { return parse_numbers(text(key)); }

TextHeader read_text_header(const std::filesystem::path& path, const TextHeaderStyle& style) {
  TextHeader header;
  std::ifstream stream(path, std::ios::binary);
  std::string line;
  for (bool first = true; header.bytes < longest_header && std::getline(stream, line); first = false) {
    header.bytes += line.size() + 1;
    line = trimmed(line);
    if (line.empty() && style.ends_at_empty_line) return header;
    if (first) header.first_line = line;
    const auto separator = line.find(style.separator);
    if (line.starts_with('#') || separator == std::string::npos) continue;
    const std::string key = in_lower_case(trimmed(line.substr(0, separator)));
    header.values[key] = trimmed(line.substr(separator + 1));
    if (!style.last_key.empty() && key == style.last_key) return header;
  }
  const bool may_end_here = style.ends_at_empty_line && stream.eof();  // detached headers have no empty line
  if (!may_end_here) throw InputError(path.string(), "its header has no end", "it is truncated or another format");
  return header;
}

std::vector<double> parse_numbers(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::vector<double> numbers;
  for (double number = 0; stream >> number;) numbers.push_back(number);
  return stream.eof() ? numbers : std::vector<double>();
}

Eigen::Vector3i whole_sizes(const std::vector<double>& sizes) {
  Eigen::Vector3i whole = Eigen::Vector3i::Ones();
  for (std::size_t i = 0; i < sizes.size() && i < 3; ++i)
    whole[static_cast<int>(i)] =
        sizes[i] >= 1 && sizes[i] <= 1e9 && sizes[i] == std::floor(sizes[i]) ? static_cast<int>(sizes[i]) : 0;
  return whole;
}

}  // namespace isostack
