#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace isostack {

/// Orders names as people number them: "slice2" before "slice10".
bool natural_less(std::string_view a, std::string_view b);

enum class Depth { kThisFolder, kAllBelow };

/// Regular files in the folder, or also in the folders below it, in natural order of their paths.
/// Symbolic links to folders are not followed, so loops end. Throws InputError naming the folder when it cannot be
/// read.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, Depth depth);

/// Throws InputError unless something exists at `path`.
void require_exists(const std::filesystem::path& path);

}  // namespace isostack
