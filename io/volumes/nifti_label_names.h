#pragma once

#include <string>
#include <vector>

#include "io/volumes/nifti_header.h"
#include "recon/geometry/label_map.h"

namespace isostack {

/// Names and colours of labels in a NIfTI header extension: the XML table <LabelTable> of Connectome Workbench
/// (extension code 30), which TotalSegmentator writes too (code 0). Empty when there is none or it is damaged.
/// All are segments of the first layer.
std::vector<Segment> read_nifti_label_names(const NiftiHeader& header);

/// The bytes between the header and the voxels, at least the four that say whether there is an extension.
std::string nifti_label_extension(const std::vector<Segment>& segments);

}  // namespace isostack
