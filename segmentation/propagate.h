#pragma once

#include <string>
#include <vector>

#include "segmentation/organ_scene.h"

namespace isostack {

/// Region steps and evolution of one organ, plane by plane from its seeds outwards (OrganOptions::propagate_mm).
/// Returns remarks.
std::vector<std::string> propagate(OrganRegion& organ, const OrganScene& scene, const std::vector<StartStep>& steps,
                                   const OrganOptions& options);

}  // namespace isostack
