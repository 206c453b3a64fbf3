#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "cli/session.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/geometry/volume.h"

namespace isostack::cli {

/// How files that hold bodies as such are taken.
struct BodyOptions {
  std::string distances;  ///< "inside", "outside": volumes of real numbers hold signed distances that are positive
                          ///< there. Empty: those whose headers say that they hold distances
  bool mend = false;      ///< meshes that are open, cross themselves or disagree about the outside
};

/// --distances
void add_distance_option(CLI::App& command, BodyOptions& options);
/// --mend
void add_mend_option(CLI::App& command, BodyOptions& options);

/// Meshes, not contours in files that may hold either.
bool is_mesh(const std::filesystem::path& path);

/// True for volumes that say that they hold signed distances, or that --distances says it of.
bool is_distance_volume(const std::filesystem::path& path, const BodyOptions& options);

/// Its distances, positive inside.
Volume<float> read_distance_volume(const std::filesystem::path& path, const BodyOptions& options);

/// The mesh in the file; the surface of a constructive solid, on voxels of a hundredth of its longest side; of a
/// distance volume, where it is 0. Nothing for other files. What was mended is noted. Throws InputError naming the
/// file.
std::optional<TriangleMesh> read_body(const std::filesystem::path& path, const BodyOptions& options, Session& session);

}  // namespace isostack::cli
