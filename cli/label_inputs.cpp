#include "cli/label_inputs.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/dicom/dicom_seg.h"
#include "io/volumes/volume_files.h"
#include "recon/geometry/errors.h"
#include "segmentation/segment.h"

namespace isostack::cli {

namespace {

/// The label inputs as one scene: slices of all their grids, without values.
struct LabelScene {
  std::vector<LabelMap> maps;
  std::vector<std::string> sources;  ///< of each map, for messages
  SliceStack stack;
};

LabelScene read_scene(const InputOptions& options, Session& session) {
  LabelScene scene;
  for (const std::filesystem::path& path : options.paths) {
    session.progress().report("read", 0);
    const std::string name = path.filename().string();
    if (scene.stack.name.empty()) scene.stack.name = name;
    std::size_t number = 0;  // one for all maps of the file
    for (LabelMap& map : read_label_planes(path)) {
      for (const std::string& warning : map.warnings) session.note(warning);
      for (Slice& slice : slices_of(Volume<float>(map.layers.front().grid), name)) {
        slice.name = fmt::format("{} slice {}", name, number++);
        scene.stack.slices.push_back(std::move(slice));
      }
      scene.sources.push_back(path.string());
      scene.maps.push_back(std::move(map));
    }
  }
  return scene;
}

/// Gives the scene's pixels the value 1 where the organ is, 0 elsewhere.
void show_organ(const std::string& name, const std::vector<std::vector<Segment>>& segments, LabelScene& scene) {
  std::size_t first_slice = 0;
  for (std::size_t m = 0; m < scene.maps.size(); ++m) {
    const Grid& grid = scene.maps[m].layers.front().grid;
    for (int k = 0; k < grid.size.z(); ++k) {
      float* pixels = scene.stack.slices[first_slice + static_cast<std::size_t>(k)].pixels.data();
      const std::size_t begin = grid.offset(0, 0, k), end = grid.offset(0, 0, k + 1);
      std::fill(pixels, pixels + (end - begin), 0.0f);
      for (const Segment& segment : segments[m]) {
        if (segment.name != name) continue;
        const std::vector<std::uint16_t>& voxels = scene.maps[m].layers[segment.layer].voxels;
        for (std::size_t i = begin; i < end; ++i)
          if (voxels[i] == segment.value) pixels[i - begin] = 1;
      }
    }
    first_slice += static_cast<std::size_t>(grid.size.z());
  }
}

bool is_shown(const SliceStack& stack) {
  return std::any_of(stack.slices.begin(), stack.slices.end(),
                     [](const Slice& slice) { return (slice.pixels != 0).any(); });
}

/// One entry per map. Not every map has to hold a wanted organ, but one must.
std::vector<std::vector<Segment>> segments_of_maps(const LabelScene& scene, const std::string& label) {
  std::vector<std::vector<Segment>> segments;
  std::size_t found = 0;
  for (std::size_t m = 0; m < scene.maps.size(); ++m) {
    const bool is_last_chance = m + 1 == scene.maps.size() && found == 0;
    try {
      segments.push_back(chosen_segments(scene.maps[m], label, scene.sources[m]));
    } catch (const InputError&) {
      if (is_last_chance) throw;
      segments.emplace_back();
    }
    found += segments.back().size();
  }
  return segments;
}

/// Names in order of their first appearance, with a colour where any map has one.
std::vector<ContourStack> organs_named_in(const std::vector<std::vector<Segment>>& segments) {
  std::vector<ContourStack> organs;
  for (const std::vector<Segment>& of_map : segments)
    for (const Segment& segment : of_map) {
      auto same = std::find_if(organs.begin(), organs.end(), [&](const auto& o) { return o.name == segment.name; });
      if (same == organs.end()) same = organs.insert(organs.end(), ContourStack{.name = segment.name, .slices = {}});
      if (!same->color) same->color = segment.color;
    }
  return organs;
}

}  // namespace

bool holds_named_organs(const std::filesystem::path& path) {
  return path.filename().string().ends_with(".seg.nrrd") || is_dicom_seg(path);
}

std::vector<ContourStack> organs_in_labels(const InputOptions& options, Session& session) {
  LabelScene scene = read_scene(options, session);
  const std::string label = options.label.empty() ? "all" : options.label;
  const std::vector<std::vector<Segment>> segments = segments_of_maps(scene, label);
  const LabelOptions tracing{.fill_holes = options.segmentation.fill_holes, .largest = options.segmentation.largest};
  std::vector<ContourStack> organs;
  for (ContourStack& organ : organs_named_in(segments)) {
    show_organ(organ.name, segments, scene);
    const SliceStack chosen = chosen_slices(scene.stack, options);
    if (!is_shown(chosen)) {
      session.note(fmt::format("{}: no voxel on the slices used; it is left out", organ.name));
      continue;
    }
    organ.slices = trace_label(chosen, 1, tracing, session.progress()).slices;
    organs.push_back(std::move(organ));
  }
  if (organs.empty())
    throw InputError(scene.stack.name, "no slice that is used shows the organ", "use more slices or another --label");
  return organs;
}

}  // namespace isostack::cli
