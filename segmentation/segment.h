#pragma once

#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/geometry/slice.h"

namespace isostack {

/// How grey slices become contours. Lengths in pixels refer to the smaller pixel spacing.
struct SegmentationOptions {
  double level = 0;                  ///< the organ is where the (filtered) image is at least this bright
  bool brighter_inside = true;       ///< false: the organ is darker than the level
  double gaussian_sigma_pixels = 0;  ///< low-pass filter before everything else; 0: none
  double curvature = 0;     ///< weight β of the curvature term, pixels; 0: contours are the exact level curves
  int max_steps = 100;      ///< level-set steps at most (only used when curvature > 0)
  bool fill_holes = false;  ///< per slice: background that does not reach the image border becomes organ
  bool largest = false;     ///< keep only the largest 3D component over the stack
};

/// Contours of the organ on every slice, also those where it is absent (no contours there).
/// The simple case of segment_organs() (organs.h). Throws as that does, for instance InputError when no slice has a
/// pixel on the organ's side of the level, or none on the other.
ContourStack segment(const SliceStack& stack, const SegmentationOptions& options, const Progress& progress = {});

struct LabelOptions {
  bool fill_holes = false;  ///< as in SegmentationOptions
  bool largest = false;     ///< as in SegmentationOptions
};

/// Contours of one label of a label stack, traced through a smoothed indicator; every pixel centre
/// stays on its side. Throws InputError (listing the labels present) when no pixel has the label.
ContourStack trace_label(const SliceStack& stack, int label, const LabelOptions& options = {},
                         const Progress& progress = {});

/// Labels other than 0 in the stack, ascending. Throws InputError on values that are not whole numbers.
std::vector<int> labels_in(const SliceStack& stack);

}  // namespace isostack
