#include "cli/pipeline/content_hash.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack::cli {

namespace {

namespace fs = std::filesystem;

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) { EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr); }
  void add(const char* bytes, std::size_t count) { EVP_DigestUpdate(context_.get(), bytes, count); }
  std::string hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    EVP_DigestFinal_ex(context_.get(), digest.data(), &size);
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
      text += digits[digest[i] >> 4U];
      text += digits[digest[i] & 15U];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

std::string file_hash(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string(), "it cannot be read", "check its permissions");
  Sha256 hash;
  std::vector<char> block(1U << 20U);
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())), stream.gcount() > 0)
    hash.add(block.data(), static_cast<std::size_t>(stream.gcount()));
  return hash.hex();
}

/// The files with the voxels that a MetaImage or NRRD header names; none when they are in the same file.
std::vector<fs::path> voxel_files(const fs::path& header) {
  std::vector<fs::path> files;
  std::ifstream stream(header, std::ios::binary);
  for (std::string line; line.size() < 4096 && std::getline(stream, line) && !line.empty();) {
    const std::size_t separator = line.find_first_of("=:");
    const std::string key = line.substr(0, separator);
    if (separator == std::string::npos || (!key.starts_with("ElementDataFile") && !key.starts_with("data file")))
      continue;
    const std::size_t begin = line.find_first_not_of(" \t", separator + 1), end = line.find_last_not_of(" \t\r");
    if (begin == std::string::npos) continue;
    const fs::path file = header.parent_path() / line.substr(begin, end - begin + 1);
    if (fs::is_regular_file(file)) files.push_back(file);
  }
  return files;
}

bool is_below(const fs::path& file, const fs::path& place) {
  const fs::path relative = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(place));
  return !relative.empty() && *relative.begin() != "..";
}

template <class Iterator>
void add_files(Iterator entries, const std::string& extension, std::vector<fs::path>& files) {
  for (const auto& entry : entries)
    if (entry.is_regular_file() && (extension.empty() || entry.path().extension() == extension))
      files.push_back(entry.path());
}

/// Everything that is read when a command is given the path.
std::vector<fs::path> files_of(const fs::path& path, const std::vector<fs::path>& without) {
  std::vector<fs::path> files;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (fs::is_directory(path))
    add_files(fs::recursive_directory_iterator(path), "", files);
  else if (path.extension() == ".dcm")
    add_files(fs::directory_iterator(folder), ".dcm", files);
  else
    files = path.extension() == ".mhd" || path.extension() == ".nhdr" ? voxel_files(path) : files;
  std::erase_if(files, [&](const fs::path& file) {
    return fs::equivalent(file, path) ||
           std::any_of(without.begin(), without.end(), [&](const fs::path& other) { return is_below(file, other); });
  });
  if (!fs::is_directory(path)) files.push_back(path);
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::string sha256_of(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes.data(), bytes.size());
  return hash.hex();
}

std::string output_hash(const fs::path& path) { return fs::is_directory(path) ? content_hash(path) : file_hash(path); }

std::string content_hash(const fs::path& path, const std::vector<fs::path>& without) {
  if (!fs::exists(path)) throw InputError(path.string(), "there is no such file or folder", "check the path");
  const std::vector<fs::path> files = files_of(path, without);
  if (files.size() == 1 && !fs::is_directory(path)) return file_hash(files.front());
  const fs::path root = fs::is_directory(path) ? path : path.parent_path();
  Sha256 all;
  for (const fs::path& file : files) {
    const std::string line = file_hash(file) + "  " + file.lexically_relative(root).generic_string() + "\n";
    all.add(line.data(), line.size());
  }
  return all.hex();
}

}  // namespace isostack::cli
