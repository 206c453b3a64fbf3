#pragma once

#include <filesystem>

#include "io/contours/contour_file.h"
#include "io/read_slices.h"
#include "io/write_options.h"

namespace isostack {

/// True when the file is a DICOM RT Structure Set. Files that are not DICOM or are damaged are not.
bool is_rtstruct(const std::filesystem::path& path);

/// Reads a DICOM RT Structure Set (PS3.3, C.8.8.5 and C.8.8.6): one stack per ROI, in the file's order, with its name,
/// colour and interpreted type; ROIs without contours, too. Closed contours are grouped by the plane they lie in.
/// Within a plane the inside is what lies within an odd number of contours (options.unite_contours: within any), so
/// holes may be loops of their own or joined by a keyhole; contours that touch, cross or overlap come out as loops
/// that do not. Points, open and non-planar contours are left out with a warning.
/// Planes on which other contours of the file or the images (options.images) show that the organ was not drawn are
/// slices without contours. Pixel size and count are those of the images, or 1 mm and unknown.
/// Throws InputError naming the file, and the ROI where one is to blame, when it is damaged.
ContourFile read_rtstruct(const std::filesystem::path& path, const ReadOptions& options = {});

/// Writes one ROI per organ; every loop becomes a CLOSED_PLANAR contour, holes are to be read by even-odd. Coordinates
/// are kept to 0.1 micrometre. options.like, an image series, gives study, frame of
/// reference and the images that the contours refer to; without it the file refers to a frame of reference of its own.
/// Patient name, ID and the like are empty unless options.identify. Equal input gives an equal file: UIDs follow from
/// the content. Throws InputError naming the file or organ when it cannot be written, or `like` is not an image series.
void write_rtstruct(const std::vector<ContourStack>& organs, const std::filesystem::path& path,
                    const WriteOptions& options = {});

}  // namespace isostack
