#include "io/atomic_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <system_error>

#include "recon/geometry/errors.h"

namespace isostack {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void throw_unwritable(const fs::path& target, const std::error_code& error) {
  throw InputError(target.string(), "the folder cannot be written (" + error.message() + ")",
                   "choose a place that exists, is writable and has free space");
}

/// "frames/" as "frames".
fs::path without_slash(const fs::path& path) { return path.has_filename() ? path : path.parent_path(); }

fs::path neighbour_of(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  fs::path neighbour = target;
  neighbour.replace_filename(fmt::format(".{}-{}.part.{}", ::getpid(), counter++, target.filename().string()));
  return neighbour;
}

}  // namespace

void AtomicFolder::require_replaceable(const fs::path& path, const std::string& prefix) {
  const fs::path target = without_slash(path);
  const fs::path parent = target.has_parent_path() ? target.parent_path() : ".";
  if (!fs::is_directory(parent))
    throw InputError(target.string(), "its folder does not exist", "create " + parent.string());
  if (!fs::exists(target)) return;
  if (!fs::is_directory(target))
    throw InputError(target.string(), "it is a file, not a folder", "choose another name for the folder");
  for (const auto& entry : fs::directory_iterator(target))
    if (!entry.is_regular_file() || !entry.path().filename().string().starts_with(prefix))
      throw InputError(target.string(),
                       "the folder holds " + entry.path().filename().string() + ", which is not a frame",
                       "choose an empty or new folder");
}

AtomicFolder::AtomicFolder(const fs::path& target, const std::string& prefix) : target_(without_slash(target)) {
  require_replaceable(target_, prefix);
  temporary_ = neighbour_of(target_);
  std::error_code error;
  if (!fs::create_directory(temporary_, error)) throw_unwritable(target_, error);
}

AtomicFolder::~AtomicFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void AtomicFolder::commit() {
  std::error_code error;
  fs::path old;
  if (fs::exists(target_)) {
    old = neighbour_of(target_);
    fs::rename(target_, old, error);
    if (error) throw_unwritable(target_, error);
  }
  fs::rename(temporary_, target_, error);
  if (error) {
    const std::error_code reason = error;
    if (!old.empty()) fs::rename(old, target_, error);
    throw_unwritable(target_, reason);
  }
  temporary_.clear();
  if (!old.empty()) fs::remove_all(old, error);
}

}  // namespace isostack
