#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace isostack::cli {

/// What a pipeline's steps were made of and what came out, so that what has not changed need not run again.
class RunState {
 public:
  /// Empty when there is no such file, or none that can be understood: then everything runs.
  explicit RunState(std::filesystem::path file);

  /// True when the step had this key and everything it wrote is there as it was.
  bool is_current(const std::string& step, const std::string& key) const;
  /// Files the step wrote.
  std::vector<std::string> written(const std::string& step) const;
  /// Remembers, in the file too.
  void remember(const std::string& step, const std::string& key, const std::vector<std::string>& written);
  /// Before a step runs: what it may leave half done counts for nothing.
  void forget(const std::string& step);

 private:
  struct Entry {
    std::string key;
    std::map<std::string, std::string> outputs;  ///< path, content hash
  };
  void write() const;

  std::filesystem::path file_;
  std::map<std::string, Entry> entries_;
};

}  // namespace isostack::cli
