#include "io/dicom/series_planes.h"

#include "io/dicom/dicom_reference.h"
#include "io/file_listing.h"
#include "io/formats.h"
#include "recon/geometry/errors.h"

namespace isostack {

std::vector<ContourSlice> series_planes(const WriteOptions& options) {
  if (!options.like) throw InputError("--like", "it is not given", "name the image series whose planes are meant");
  const std::filesystem::path& path = *options.like;
  require_exists(path);
  std::vector<ContourSlice> planes;
  if (const Format* format = find_format(path, &Format::read_volume_header)) {
    const Grid grid = format->read_volume_header(path).grid;
    for (int k = 0; k < grid.size.z(); ++k)
      planes.push_back({.name = path.filename().string() + " " + std::to_string(k),
                        .pose = pose_of_plane(grid, k, path.string()),
                        .size_pixels = grid.size.head<2>(),
                        .contours = {}});
    return planes;
  }
  for (const ReferencedImage& image : referenced_series(options).images)
    planes.push_back({.name = image.name, .pose = image.pose, .size_pixels = image.size_pixels, .contours = {}});
  return planes;
}

}  // namespace isostack
