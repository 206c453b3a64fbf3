#pragma once

#include <cstddef>
#include <vector>

#include "recon/organ_surface.h"
#include "recon/surface/extract_surface.h"

namespace isostack {

/// A contour none of whose samples has a surface near it, by the numbers of these among the organ's samples.
using LostContour = std::vector<std::size_t>;

/// Contours wider than a speck that `lost_seeds`, numbers of samples without a surface, hold wholly.
std::vector<LostContour> lost_contours(const FittedOrgan& organ, const std::vector<std::size_t>& lost_seeds);

/// Gives lost contours that lie on small closed parts of the zero set a surface in finer cells, added to the extracted
/// one; returns those that are lost still. `extraction`: how the surface was extracted.
std::vector<LostContour> add_lost_parts(const std::vector<LostContour>& lost, const FittedOrgan& organ,
                                        const ScalarField& field, const ExtractionOptions& extraction,
                                        ExtractedSurface& extracted);

}  // namespace isostack
