#include "segmentation/label_sections.h"

#include <tbb/parallel_for.h>

#include "recon/geometry/errors.h"

namespace isostack {

namespace {

/// The label layer's values at the plane's pixel centres: 1 where the segment is.
Image<float> mask_on(const ContourSlice& plane, const LabelVolume& layer, std::uint16_t value) {
  const Eigen::Affine3d world_to_index = layer.grid.index_to_world.inverse();
  const Eigen::Vector3d start = world_to_index * plane.pose.origin_mm;
  const Eigen::Vector3d column_step = world_to_index.linear() * plane.pose.x_axis * plane.pose.spacing_mm.x();
  const Eigen::Vector3d row_step = world_to_index.linear() * plane.pose.y_axis * plane.pose.spacing_mm.y();
  Image<float> mask = Image<float>::Zero(plane.size_pixels.y(), plane.size_pixels.x());
  for (Eigen::Index row = 0; row < mask.rows(); ++row)
    for (Eigen::Index column = 0; column < mask.cols(); ++column) {
      const Eigen::Array3d nearest =
          (start + static_cast<double>(row) * row_step + static_cast<double>(column) * column_step).array().round();
      if ((nearest < 0).any() || (nearest >= layer.grid.size.cast<double>().array()).any()) continue;
      const Eigen::Vector3i index = nearest.cast<int>();
      if (layer.voxels[layer.grid.offset(index.x(), index.y(), index.z())] == value) mask(row, column) = 1;
    }
  return mask;
}

}  // namespace

std::vector<ContourStack> label_sections(const LabelMap& labels, const std::vector<Segment>& segments,
                                         const std::vector<ContourSlice>& planes, const LabelOptions& options,
                                         const Progress& progress) {
  SliceStack stack;
  for (const ContourSlice& plane : planes) {
    if (plane.size_pixels.minCoeff() <= 0)
      throw GeometryError(plane.name, "it is not known how many pixels the plane has", "give the planes of images");
    stack.slices.push_back({plane.name, plane.pose, {}});
  }
  std::vector<ContourStack> organs;
  for (const Segment& segment : segments) {
    stack.name = segment.name;
    tbb::parallel_for(std::size_t{0}, planes.size(), [&](std::size_t i) {
      stack.slices[i].pixels = mask_on(planes[i], labels.layers.at(segment.layer), segment.value);
    });
    ContourStack& organ = organs.emplace_back(trace_label(stack, 1, options, progress));
    organ.name = segment.name;
    organ.color = segment.color;
  }
  return organs;
}

}  // namespace isostack
