#include "io/file_listing.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Takes the leading number off `text`, without its leading zeros.
std::string_view take_number(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

template <class Iterator>
std::vector<std::filesystem::path> regular_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  try {
    for (const auto& entry : Iterator(folder))
      if (std::error_code dangling; entry.is_regular_file(dangling)) files.push_back(entry.path());
  } catch (const std::filesystem::filesystem_error& error) {
    throw InputError(folder.string(), "the folder cannot be read (" + error.code().message() + ")",
                     "check that it exists and that you may read it");
  }
  return files;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  std::string_view rest_a = a, rest_b = b;
  while (!rest_a.empty() && !rest_b.empty()) {
    if (is_digit(rest_a.front()) && is_digit(rest_b.front())) {
      const std::string_view number_a = take_number(rest_a), number_b = take_number(rest_b);
      if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
      if (number_a != number_b) return number_a < number_b;
    } else {
      if (rest_a.front() != rest_b.front()) return rest_a.front() < rest_b.front();
      rest_a.remove_prefix(1);
      rest_b.remove_prefix(1);
    }
  }
  if (rest_a.empty() != rest_b.empty()) return rest_a.empty();
  return a < b;  // equal but for leading zeros
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, Depth depth) {
  auto files = depth == Depth::kAllBelow ? regular_files<std::filesystem::recursive_directory_iterator>(folder)
                                         : regular_files<std::filesystem::directory_iterator>(folder);
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return natural_less(a.native(), b.native()); });
  return files;
}

void require_exists(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw InputError(path.string(), "there is no such file or folder", "check the path");
}

}  // namespace isostack
