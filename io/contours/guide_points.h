#pragma once

#include <filesystem>

#include "io/contours/contour_file.h"
#include "io/read_slices.h"

namespace isostack {

/// Guide points of cardiac MR: a text file of points per traced surface and slice (columns x, y, z, contour type,
/// slice, weight, time frame; world mm), with the poses of the slices in a file SliceInfo*.txt beside it.
bool holds_guide_points(const std::filesystem::path& path);

/// Closed contours of "LV endocardium", "RV endocardium" (septum and free wall joined) and "epicardium" (of both
/// ventricles), as far as they are there. The points of an organ on a slice are ordered to the shortest loop; where
/// a wall is open, at the valves, it is closed straight through the valve's points. A slice on which an organ is not
/// traced says nothing about it and is no slice of its stack. What cannot be closed is left out with a warning. Throws
/// InputError naming file and line when it is damaged, or when the poses are missing or contradict the points.
ContourFile read_guide_points(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace isostack
