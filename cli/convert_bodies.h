#pragma once

#include <filesystem>

#include "cli/body_inputs.h"
#include "cli/session.h"
#include "io/write_options.h"

namespace isostack::cli {

/// Bodies as surfaces, or as volumes of signed distances.
struct BodyConversion {
  BodyOptions bodies;
  double voxel_mm = 0;         ///< of a distance volume round the body; 0: not given
  std::filesystem::path grid;  ///< that a distance volume takes over; empty: not given
};

/// --voxel, --grid, --distances, --mend
void add_body_options(CLI::App& command, BodyConversion& options);

/// Whether `input` is to become another kind of body: a mesh or solid a distance volume, a solid or distance volume a
/// mesh, or a volume is to be marked as one of distances.
bool converts_body(const std::filesystem::path& input, const std::filesystem::path& output,
                   const BodyConversion& options);

/// Does it. What is wrong with a mesh, and what was done about it, is noted. The result gets "error_mm", the most by
/// which a solid's distances may be off, and "voxels".
void convert_body(const std::filesystem::path& input, const std::filesystem::path& output,
                  const BodyConversion& options, const WriteOptions& writing, Session& session);

}  // namespace isostack::cli
