#pragma once

#include <filesystem>

#include "recon/geometry/csg_solid.h"

namespace isostack {

/// Reads a constructive solid (docs/distance.md describes the format):
///
///     {"format": "isostack-solid", "version": 1, "solid": NODE}
///
/// NODE has exactly one of "superellipsoid": {"radii_mm": [a1, a2, a3], "exponents": [e1, e2]} (exponents may be left
/// out: [1, 1]), "union", "intersection", "difference": [NODE, ...], and may have "name" and "affine": three rows of
/// four numbers, mm, applied to all of it. World LPS mm.
/// Throws InputError naming the file and the place in it for what is missing, unknown, out of range or empty.
CsgSolid read_solid(const std::filesystem::path& path);

/// True for a readable .json file that names the format within its first thousand bytes.
bool holds_solid(const std::filesystem::path& path);

}  // namespace isostack
