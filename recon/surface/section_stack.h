#pragma once

#include <string>
#include <vector>

#include "recon/geometry/contour.h"
#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"

namespace isostack {

/// A closed surface cut back onto planes, such as those of an image series: one slice for each of them, with the
/// plane's name, pose and size, and the contours that plane_section finds there (none where the surface does not
/// reach). Name and colour are the mesh's unless `name` is given. Planes are cut in parallel; the result does not
/// depend on the number of threads. Throws GeometryError when the mesh has an open edge, for then its inside is not
/// defined.
ContourStack section_stack(const TriangleMesh& mesh, const std::vector<ContourSlice>& planes,
                           const std::string& name = {}, const Progress& progress = {});

}  // namespace isostack
