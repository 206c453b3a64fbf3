#pragma once

#include <string>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// What a contour file holds, one stack per organ, and what the user should know about it: contours left out, planes
/// taken as empty. Nothing in it identifies a patient.
struct ContourFile {
  std::vector<ContourStack> organs;
  std::vector<std::string> warnings = {};
};

}  // namespace isostack
