#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "recon/geometry/slice_pose.h"

namespace isostack {

/// A 2D raster, indexed (row, column); the pixel position (x, y) is (column, row).
template <class T>
using Image = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Pixels at their place in the patient. Grey values are in the modality's units
/// (CT: HU, rescale applied); label images hold whole numbers, 0 = background.
struct Slice {
  std::string name;  ///< names the slice in messages: file name, or volume name and index
  SlicePose pose;
  Image<float> pixels;
};

/// Slices of one scene, in the order the reader found sensible (along the normal for
/// parallel ones). They may be parallel or not, evenly spaced or not.
struct SliceStack {
  std::string name;  ///< free of patient data
  std::vector<Slice> slices;
  std::vector<std::string> warnings;  ///< what a user must know before trusting the stack
};

/// Position of each slice's origin along the mean normal, mm; for parallel stacks.
std::vector<double> positions_along_normal_mm(const std::vector<Slice>& slices);

}  // namespace isostack
