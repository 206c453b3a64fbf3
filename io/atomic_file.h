#pragma once

#include <filesystem>
#include <string_view>

namespace isostack {

/// A file that appears whole or not at all. Write to temporary(), then commit(); without a commit
/// the temporary file is deleted and whatever was at the target before is left alone.
class AtomicFile {
 public:
  /// Creates an empty file beside `target`, with the same extension, for it to replace. Throws
  /// InputError naming the target when its folder is missing or cannot be written to.
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }

  /// Flushes to disk and renames. Throws InputError naming the target when the disk is full.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

/// Writes the bytes to `target` as an AtomicFile.
void write_whole_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace isostack
