#pragma once

#include <vector>

#include "recon/geometry/slice.h"

namespace isostack {

/// Grey values of an organ: low <= I <= high; either may be infinite.
struct GreyRange {
  double low, high;

  /// How far a value is within the range, negative outside: the field whose zero set is the range's edge.
  double depth(double grey) const { return low - grey > grey - high ? grey - low : high - grey; }
};

/// depth() of every pixel.
Image<float> depth_in_range(const Image<float>& image, const GreyRange& range);

struct OtsuClasses {
  double level, dark_mean, bright_mean;
};

/// The level that splits the pixels of all images into two classes with the largest variance between them
/// (Otsu 1979), and the classes' means, from 1024 bins between the 0.1 and 99.9 % quantiles, so that a few extreme
/// pixels do not matter. NaN when all pixels are equal.
OtsuClasses otsu_classes(const std::vector<Image<float>>& images);

}  // namespace isostack
