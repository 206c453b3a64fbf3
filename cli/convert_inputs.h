#pragma once

#include <filesystem>

#include "cli/input_options.h"
#include "cli/session.h"
#include "io/volumes/stored_volume.h"

namespace isostack::cli {

enum class InputKind { kContours, kMesh, kLabels, kVolume };

const char* name_of(InputKind kind);

/// What the input is, by its content where one extension stands for several kinds. A file of voxels counts as labels
/// when it names organs, or when `output` can hold nothing else. Throws InputError when it is nothing that can be read.
InputKind kind_of(const std::filesystem::path& input, const std::filesystem::path& output);

/// A volume file as it is stored, or an evenly spaced image series as one volume. Notes the reader's warnings.
StoredVolume read_as_volume(const InputOptions& input, Session& session);

}  // namespace isostack::cli
