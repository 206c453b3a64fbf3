#include "io/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

[[noreturn]] void throw_unwritable(const std::filesystem::path& target, const std::string& reason) {
  throw InputError(target.string(), "cannot be written (" + reason + ")",
                   "choose a folder that exists, is writable and has free space");
}

/// Flushing here, before the rename, is what makes a full disk show up.
bool flush_to_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool flushed = ::fsync(descriptor) == 0;
  const int reason = errno;
  const bool closed = ::close(descriptor) == 0;
  if (!flushed) errno = reason;
  return flushed && closed;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target) : target_(std::move(target)) {
  if (!target_.has_filename() || std::filesystem::is_directory(target_)) throw_unwritable(target_, "it is a folder");
  static std::atomic<unsigned> counter{0};  // keeps threads apart; the process id keeps programs apart
  for (int attempt = 0; attempt < 1000; ++attempt) {
    // The whole name comes last, so that writers choose by the same extension (".nii.gz").
    temporary_ = target_;
    temporary_.replace_filename(fmt::format(".{}-{}.part.{}", ::getpid(), counter++, target_.filename().string()));
    const int descriptor = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor >= 0) {
      ::close(descriptor);
      return;
    }
    if (errno != EEXIST) break;
  }
  throw_unwritable(target_, std::strerror(errno));
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  if (!flush_to_disk(temporary_)) throw_unwritable(target_, std::strerror(errno));
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error) throw_unwritable(target_, error.message());
  temporary_.clear();
}

void write_whole_file(const std::filesystem::path& target, std::string_view bytes) {
  AtomicFile file(target);
  std::ofstream stream(file.temporary(), std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw_unwritable(target, std::strerror(errno));
  file.commit();
}

}  // namespace isostack
