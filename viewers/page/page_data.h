#pragma once

#include <nlohmann/json_fwd.hpp>

#include "viewers/page/page.h"

namespace isostack {

/// The scene as page.js reads it; arrays of numbers are little-endian bytes in base 64.
nlohmann::json page_data(const Scene& scene, const PageOptions& options);

}  // namespace isostack
