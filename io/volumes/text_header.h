#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace isostack {

/// The "key: value" lines at the beginning of a file. Keys are in lower case.
struct TextHeader {
  std::string first_line;  ///< without a separator: a magic
  std::map<std::string, std::string> values;
  std::uintmax_t bytes = 0;  ///< length of the header

  std::string text(const std::string& key) const;             ///< empty when absent
  std::string lower(const std::string& key) const;            ///< the same in lower case
  std::vector<double> numbers(const std::string& key) const;  ///< empty when absent or not all numbers
};

/// How the lines are written and where they end.
struct TextHeaderStyle {
  char separator = ':';
  bool ends_at_empty_line = false;
  std::string last_key = {};  ///< the header ends with this key's line
};

/// Throws InputError naming the file when it cannot be read or has no such end within 1 MiB.
TextHeader read_text_header(const std::filesystem::path& path, const TextHeaderStyle& style);

/// Numbers separated by white space; empty when anything else occurs.
std::vector<double> parse_numbers(const std::string& text);

/// The first three sizes as whole numbers, 1 for those missing, 0 for what is not a size.
Eigen::Vector3i whole_sizes(const std::vector<double>& sizes);

}  // namespace isostack
