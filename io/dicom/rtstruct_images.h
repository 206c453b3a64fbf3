#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/read_slices.h"
#include "recon/geometry/contour.h"

namespace isostack {

/// The images a structure set was drawn on, as slices without contours.
struct RtImages {
  std::vector<ContourSlice> slices;
  std::string warning;  ///< when there are none, or not quite those it names
};

/// Looks for the series among the files in the folder of `structure_set`, or in options.images and below. Throws
/// InputError when options.images is given and holds no series that fits.
RtImages find_rt_images(const std::filesystem::path& structure_set, const std::vector<std::string>& series_uids,
                        const ReadOptions& options);

}  // namespace isostack
