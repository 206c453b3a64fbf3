#pragma once

#include <string>

#include "recon/geometry/contour.h"

namespace isostack {

/// What every contour reader does at the end of a slice: the pose is checked, a repeated last point
/// dropped, nesting and orientation computed. Throws InputError naming `file` and the slice when a
/// curve has fewer than three points, points that are not numbers, or crosses itself.
void complete_slice(ContourSlice& slice, const std::string& file);

/// "FILE, slice NAME" for messages.
std::string contour_place(const std::string& file, const std::string& slice);

/// Throws InputError: the curve does not return to its first point.
[[noreturn]] void throw_open_contour(const std::string& file, const std::string& slice);

}  // namespace isostack
