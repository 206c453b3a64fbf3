#pragma once

#include <vector>

#include "cli/input_options.h"
#include "cli/session.h"
#include "recon/morphing/shape.h"

namespace isostack::cli {

/// One key shape per input, whatever that is: a mesh, a constructive solid or several slices with contours are a body
/// (slices are reconstructed first), one slice is a figure. Of images and labels the segmentation's options say what
/// the shape is; a single grey picture without any is taken at the middle of its grey range (Turk & O'Brien 1999,
/// §4.1). Pictures that do not say how large their pixels are have pixels of 1 mm. Throws InputError naming the input.
std::vector<KeyShape> read_key_shapes(const InputOptions& options, Session& session);

}  // namespace isostack::cli
