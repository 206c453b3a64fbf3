#pragma once

#include <memory>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/morphing/key_places.h"
#include "recon/morphing/morph.h"
#include "recon/morphing/subdivision_morph.h"

namespace isostack {

/// subdivision_morph() of bodies of genus 0, or all of genus 1. Adds to the report what was held and how each level
/// went. `spacing_mm` is between neighbouring key shapes. With `sharp_angle_rad` corners where at least three edges
/// that turn more meet become base vertices, and edges that turn more stay edges at their own shape in any case: frames
/// at a key shape's time are its surface, cut up further. Throws InputError for bodies that are open, in several parts,
/// or of different or higher genus, for topological key shapes, and for features that name no vertex.
std::unique_ptr<MorphMethod> subdivided_bodies(const std::vector<KeyShape>& shapes,
                                               const SubdivisionMorphOptions& options, const KeyPlaces& places,
                                               double spacing_mm, MorphReport& report, const Progress& progress);

}  // namespace isostack
