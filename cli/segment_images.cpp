#include "cli/segment_images.h"

#include <fmt/format.h>

#include "cli/organ_options.h"
#include "cli/outputs.h"
#include "io/formats.h"
#include "io/volumes/stored_volume.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"
#include "segmentation/small_contours.h"
#include "segmentation/trace_contours.h"

namespace isostack::cli {

namespace {

void note_cut_slices(const ContourStack& organ, Session& session) {
  std::vector<const ContourSlice*> cut;
  for (const ContourSlice& slice : organ.slices)
    if (touches_border(slice)) cut.push_back(&slice);
  if (cut.empty()) return;
  const std::string slices = cut.size() == 1
                                 ? cut.front()->name
                                 : fmt::format("{} slices, {} to {}", cut.size(), cut.front()->name, cut.back()->name);
  session.note(fmt::format("{}: it is cut by the field of view on {}", organ.name, slices));
}

/// Refuses before the work.
void require_volume(const SliceStack& stack, const std::filesystem::path& path) {
  format_for(path, &Format::write_volume, "a volume of distances");
  try {
    grid_of(stack);
  } catch (const GeometryError&) {
    throw GeometryError(path.string(), "distances make a volume only of evenly spaced slices, which these are not",
                        "leave out --distance, or choose even ones with --slices");
  }
}

/// An organ's distances, one image a slice in the stack's order.
Volume<float> volume_of(const SliceStack& stack, const std::vector<Image<float>>& distances_mm) {
  Volume<float> volume(grid_of(stack));
  auto voxel = volume.voxels.begin();
  for (const Image<float>& distance : distances_mm)
    voxel = std::copy(distance.data(), distance.data() + distance.size(), voxel);
  return volume;
}

/// One volume per organ.
void write_distances(const SliceStack& stack, const SegmentedOrgans& segmented, const std::filesystem::path& path,
                     Session& session) {
  for (std::size_t organ = 0; organ < segmented.organs.size(); ++organ) {
    const bool alone = segmented.organs.size() == 1;
    const std::filesystem::path file = alone ? path : with_suffix(path, segmented.organs[organ].name);
    write_volume(stored_distances_of(volume_of(stack, segmented.distances_mm[organ])), file);
    session.wrote(file);
  }
}

}  // namespace

std::vector<ContourStack> segment_images(const SliceStack& stack, const InputOptions& options, Session& session) {
  const std::filesystem::path& distance_file = options.organ.distance_file;
  OrganOptions organ = organ_options(options);
  organ.keep_distances = !distance_file.empty();
  if (organ.keep_distances) require_volume(stack, distance_file);
  SegmentedOrgans segmented = segment_organs(stack, organ, session.progress());
  for (const std::string& remark : segmented.remarks) session.note(remark);
  for (const ContourStack& found : segmented.organs) {
    note_cut_slices(found, session);
    if (const std::string remark = remark_on_one_pixel_contours(found); !remark.empty()) session.note(remark);
  }
  if (organ.keep_distances) write_distances(stack, segmented, distance_file, session);
  return std::move(segmented.organs);
}

Volume<float> distances_in_images(const SliceStack& stack, const InputOptions& options, const std::string& where,
                                  Session& session) {
  OrganOptions organ = organ_options(options);
  organ.keep_distances = true;
  const SegmentedOrgans segmented = segment_organs(stack, organ, session.progress());
  for (const std::string& remark : segmented.remarks) session.note(remark);
  if (segmented.organs.size() != 1)
    throw InputError(where, fmt::format("{} organs were found in it", segmented.organs.size()),
                     "give seeds of one organ");
  note_cut_slices(segmented.organs.front(), session);
  return volume_of(stack, segmented.distances_mm.front());
}

}  // namespace isostack::cli
