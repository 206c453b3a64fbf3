#pragma once

#include <vector>

#include "cli/body_inputs.h"
#include "cli/input_options.h"
#include "cli/session.h"
#include "recon/morphing/shape.h"

namespace isostack::cli {

/// One key shape per input, whatever that is: what read_body takes, or several slices, are a body; one slice is a
/// figure. Slices are reconstructed; grey ones that are segmented in 3D are the surface of that segmentation's
/// distances instead. Of images and labels the segmentation's options say what
/// the shape is; a single grey picture without any is taken at the middle of its grey range (Turk & O'Brien 1999,
/// §4.1). Pictures that do not say how large their pixels are have pixels of 1 mm. Throws InputError naming the input.
std::vector<KeyShape> read_key_shapes(const InputOptions& options, const BodyOptions& bodies, Session& session);

}  // namespace isostack::cli
