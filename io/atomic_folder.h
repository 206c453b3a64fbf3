#pragma once

#include <filesystem>
#include <string>

namespace isostack {

/// A folder that appears whole or not at all. Write files into temporary(), then commit(); without a commit they are
/// deleted and what was at the target before is left alone.
class AtomicFolder {
 public:
  /// Makes an empty folder beside `target`. A folder that is there already is replaced on commit, if it holds nothing
  /// but files whose names start with `prefix`, as an earlier run leaves them. Throws InputError naming the target when
  /// it holds something else or cannot be made.
  AtomicFolder(const std::filesystem::path& target, const std::string& prefix);
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }

  void commit();

  /// What the constructor refuses, to be told before any work is done.
  static void require_replaceable(const std::filesystem::path& target, const std::string& prefix);

 private:
  std::filesystem::path target_, temporary_;
};

}  // namespace isostack
