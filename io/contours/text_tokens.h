#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace isostack {

/// Takes words and numbers off a text file one after the other; "#" begins a remark up to the end of its line.
/// Whatever is missing or wrong throws InputError naming file and line.
class TextTokens {
 public:
  explicit TextTokens(const std::filesystem::path& path);

  bool at_end();
  /// `what` completes "... is missing".
  std::string_view word(std::string_view what);
  double number(std::string_view what);
  long long whole_number(std::string_view what);
  /// A whole number from 0 on that may still be true of a file of this length, where each one needs `bytes_each`.
  std::size_t count(std::string_view what, std::size_t bytes_each);

  /// "FILE, line N" of what was read last.
  std::string where() const;
  const std::string& file() const { return file_; }
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  void skip_space();

  std::string file_, text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

}  // namespace isostack
