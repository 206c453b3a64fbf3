#pragma once

#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// LPS and RAS differ by half a turn about the third axis; the same turn leads back.
TriangleMesh lps_to_ras(TriangleMesh mesh);

}  // namespace isostack
