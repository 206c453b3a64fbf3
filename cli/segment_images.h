#pragma once

#include <string>
#include <vector>

#include "cli/input_options.h"
#include "recon/geometry/volume.h"

namespace isostack::cli {

/// Organs in grey images by the options' rules and steps; their signed distances go to the options' distance file if it
/// has one. Notes what a user should look at: slices where an organ ends by a leak or is cut by the field of view.
std::vector<ContourStack> segment_images(const SliceStack& stack, const InputOptions& options, Session& session);

/// The only organ's signed distances in mm, positive inside, in evenly spaced slices. Throws InputError naming `where`
/// for another number of organs, GeometryError for other slices.
Volume<float> distances_in_images(const SliceStack& stack, const InputOptions& options, const std::string& where,
                                  Session& session);

}  // namespace isostack::cli
