#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "recon/geometry/errors.h"

namespace isostack::fuzz {

/// A folder of this process in memory (/dev/shm) where there is one.
inline const std::filesystem::path& folder() {
  struct Folder {
    std::filesystem::path path;
    Folder() {
      const std::filesystem::path memory = "/dev/shm";
      std::error_code ignored;
      const bool has_memory = std::filesystem::is_directory(memory, ignored) && ::access(memory.c_str(), W_OK) == 0;
      path = (has_memory ? memory : std::filesystem::temp_directory_path()) /
             ("isostack_fuzz_" + std::to_string(::getpid()));
      std::filesystem::create_directories(path);
    }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static const Folder instance;
  return instance.path;
}

/// Puts the bytes into a file of this name and hands its path to each of the readers. An Error is what a damaged file
/// should give; anything else that is thrown, and what the sanitizers see, is a finding.
template <class... Read>
int feed(std::string_view bytes, const std::string& name, Read... read) {
  const std::filesystem::path path = folder() / name;
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const auto try_one = [&](auto& reader) {
    try {
      reader(path);
    } catch (const Error&) {  // a sentence for the user
    }
  };
  (try_one(read), ...);
  return 0;
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace isostack::fuzz
