#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isostack::cli {

/// SHA-256 in hexadecimal digits, as `sha256sum` prints it.
std::string sha256_of(std::string_view bytes);

/// Of a file's bytes, or of a folder as below. Throws InputError naming the file that cannot be read.
std::string output_hash(const std::filesystem::path& path);

/// Of everything that a path stands for when a command reads it. A file: its bytes. A folder, a .dcm file (a structure
/// set finds its images in its folder) or a header with its voxels in another file: names and hashes of all these
/// files. Files of `without`, or below them, do not count: what a command writes beside its input is no input. Throws
/// InputError naming the file that is missing or cannot be read.
std::string content_hash(const std::filesystem::path& path, const std::vector<std::filesystem::path>& without = {});

}  // namespace isostack::cli
