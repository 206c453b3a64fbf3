#pragma once

#include <memory>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/morphing/key_places.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/subdivision_morph.h"

namespace isostack {

/// subdivision_morph() of figures. Adds to the report what was held and how each level went. `spacing_mm` is between
/// neighbouring key shapes.
std::unique_ptr<MorphMethod> subdivided_figures(const std::vector<KeyShape>& shapes,
                                                const SubdivisionMorphOptions& options, const KeyPlaces& places,
                                                double spacing_mm, MorphReport& report, const Progress& progress);

}  // namespace isostack
